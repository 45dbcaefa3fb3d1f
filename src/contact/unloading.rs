//! Event of laws with bristles in Model Exchange where the load vanishes: it releases the bristles.

/// Normal force up to which a contact counts as unloaded at an event, in N (chosen).
pub(crate) const UNLOADED: f64 = 1e-6;

/// Normal force up to which an event releases the contact. It lies beyond the zero of the indicator, which an importer
/// approaches from either side.
pub(crate) const RELEASED: f64 = 2.0 * UNLOADED;

/// Event indicator: negative while the contact is unloaded.
pub(crate) fn load(normal_force: f64) -> f64 {
    (normal_force - UNLOADED) / (normal_force + UNLOADED)
}

/// Whether the contact is unloaded at an event.
pub(crate) fn is_unloaded(normal_force: f64) -> bool {
    normal_force <= RELEASED
}

/// Inside `impl Model`: the event at which the load comes or goes, and the states that are 0 without it.
macro_rules! released_without_load {
    ($($state:ident),+) => {
        const EVENT_INDICATORS: usize = 1;

        fn event_indicators(&self, indicators: &mut [f64]) {
            indicators[0] = $crate::contact::unloading::load(self.normal_force);
        }

        fn at_event(&mut self) {
            if $crate::contact::unloading::is_unloaded(self.normal_force) {
                $(self.$state = 0.0;)+
            }
        }
    };
}
pub(crate) use released_without_load;
