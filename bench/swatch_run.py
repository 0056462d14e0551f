"""The swatch that the scripts beside this pull, one run of it as a whole process, and the curve that it leaves."""

import csv
import os
import subprocess
import sys
import time
from bisect import bisect_left
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

SCENE = """scene: 1
name: {pattern}, {wales} wales, {courses} courses, pulled to {strain} %
fabric: {{pattern: {root}/patterns/{pattern}.yaml, wales: {wales}, courses: {courses}, yarn: acrylic_16_2,
          stitch_length: 7.23 mm, segments_per_stitch: {segments}}}
gauge: {{thickness: 1.048 mm}}
effects: {{stretch: , bend: , contact: {{sampling: 3 %, screening: 1.6}}, knots: }}
stages:
  - {{name: tighten, tighten: 100 %, hold: ends, duration: 1 s, samples: 2,
     solver: {{quasi_static: {{tolerance: 1, first_step: 2 %}}}}}}
  - {{name: relax, duration: 1 s, samples: 1, solver: {{quasi_static: {{tolerance: 0.3}}}},
     effects: {{plates: {{gap: 1.2 mm}}}}}}
  - {{name: mount, duration: {mounting} s, mount: wale, samples: {mount_samples}, effects: {{friction: , plates: {{gap: 1.2 mm}}}}}}
  - {{name: pull, duration: {duration} s, pull: {{along: wale, to: {strain} %}}, samples: {samples}, solver: {solver},
     effects: {{{effects}plates: {{gap: 1.2 mm}}}}}}
solver: {{quasi_static: {{tolerance: 0.05}}}}
"""


def swatch(pattern, wales, courses, segments, strain, samples, duration=8.0, effects="friction: , ",
           solver="{quasi_static: {tolerance: 0.05}}", mount_samples=8):
    """The text of a scene: tightened, relaxed, mounted and pulled as in examples/01_first_stitch."""
    return SCENE.format(root=ROOT, pattern=pattern, wales=wales, courses=courses, segments=segments, strain=strain,
                        samples=samples, duration=duration, effects=effects, solver=solver,
                        mounting=mount_samples / 8, mount_samples=mount_samples)


def run_once(scene, out, threads):
    """Wall time and processor time, s, and peak memory, MB, of a scene whose text is given."""
    file = out.with_suffix(".yaml")
    file.write_text(scene)
    begun = time.monotonic()
    with open(out.with_suffix(".log"), "w") as log:
        process = subprocess.Popen([ROOT / "build/wale", "run", file, "-o", out, "--threads", str(threads)],
                                   stdout=log, stderr=log, env={**os.environ, "OMP_NUM_THREADS": str(threads)})
        _, status, spent = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{file} failed: see {log.name}")
    return time.monotonic() - begun, spent.ru_utime + spent.ru_stime, spent.ru_maxrss / 1e3


class Curve:
    """The stress-strain curve of a run, straight between its samples."""

    def __init__(self, out):
        with open(out / "curve.csv") as table:
            rows = list(csv.DictReader(table))
        self.strain = [float(row["strain"]) for row in rows]
        self.stress = [float(row["stress_MPa"]) for row in rows]

    def at(self, strain):
        k = min(max(bisect_left(self.strain, strain), 1), len(self.strain) - 1)
        share = (strain - self.strain[k - 1]) / (self.strain[k] - self.strain[k - 1])
        return self.stress[k - 1] + share * (self.stress[k] - self.stress[k - 1])

    def off(self, reference):
        """The largest difference, % of the peak."""
        everywhere = self.strain + reference.strain
        return 100 * max(abs(self.at(s) - reference.at(s)) for s in everywhere) / max(reference.stress)
