//! Records of rigs, maps of friction and tyre tests, as text.

use std::path::Path;

use stribeck_fit::identify::tyre::{Axes, TyreTest};
use stribeck_fit::identify::{Inquiry, Source};
use stribeck_measured::average;
use stribeck_sheet::{Sheet, SheetError};

/// Maximum number of samples; more make the filters slow.
const MOST_SAMPLES: usize = 512;

/// A table instead of a file.
struct Text<'a>(&'a str);

impl Source for Text<'_> {
    fn tables(&self, _: &Path, _: Option<&str>) -> Result<Vec<Sheet>, SheetError> {
        Ok(vec![Sheet::parse(self.0)?])
    }
}

pub fn read(bytes: &[u8]) {
    let text = &*String::from_utf8_lossy(bytes);
    let Ok(sheet) = Sheet::parse(text) else { return };
    if sheet.len() > MOST_SAMPLES {
        return;
    }
    let inquiry = Inquiry { records: vec!["record.csv".into()], law: vec!["Dahl".to_owned()], ..Inquiry::default() };
    let loaded = Inquiry { normal_force: Some(20.0), mass: Some(1.0), ..inquiry.clone() };
    for asked in [inquiry.clone(), loaded, Inquiry { axis: true, ..inquiry }] {
        check(&asked, text);
    }
    for axes in [Axes::Iso, Axes::Sae] {
        if let Ok(test) = TyreTest::of(&sheet, axes) {
            for sample in &test.samples {
                let known = [sample.load, sample.side_slip, sample.longitudinal_slip, sample.camber];
                let measured = [sample.force_x, sample.force_y, sample.moment_z, sample.pressure];
                let mut values = known.into_iter().chain(measured.into_iter().flatten());
                assert!(values.all(f64::is_finite), "{sample:?}");
            }
        }
    }
}

fn check(asked: &Inquiry, text: &str) {
    let Ok(data) = asked.data(&Text(text)) else { return };
    for (_, record) in &data.records {
        let mean = average(record).map_or_else(Vec::new, |cycle| [cycle.friction_force, cycle.deviation].concat());
        let columns = [&record.time, &record.force, &record.displacement, &record.velocity, &record.acceleration];
        let numbers = columns.into_iter().chain([&record.friction_force, &record.normal_force, &mean]);
        assert!(numbers.flatten().all(|value| value.is_finite()), "{record:?}");
    }
    for (_, map) in &data.maps {
        assert!(map.velocity.iter().all(|value| value.is_finite()), "{map:?}");
    }
}
