PYTHON ?= python3

.PHONY: demo test bench clean

demo:
	$(PYTHON) tasks.py demo

test:
	$(PYTHON) tasks.py test

bench:
	$(PYTHON) tasks.py bench

clean:
	$(PYTHON) tasks.py clean
