PYTHON ?= python3

.PHONY: demo test bench page clean

demo:
	$(PYTHON) tasks.py demo

test:
	$(PYTHON) tasks.py test

bench:
	$(PYTHON) tasks.py bench

page:
	$(PYTHON) tasks.py page

clean:
	$(PYTHON) tasks.py clean
