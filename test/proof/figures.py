# SPDX-License-Identifier: MIT
"""The results of ./dev prove as tables."""


def results(proofs, jobs):
    """A row for each proof."""
    rows = []
    for proof in proofs:
        own = [job for job in jobs if job.proof is proof]
        bugs = [job for job in own if job.kind == "bug"]
        places = [job for job in own if job.kind == "place"]
        rows.append(
            {
                "name": proof.name,
                "says": proof.says,
                "proved": not any(job.fault() for job in own),
                "claims": own[0].verdict.claims,
                "bugs_refuted": sum(not job.fault() for job in bugs),
                "bugs": len(proof.bugs),
                "places_reached": sum(not job.fault() for job in places),
                "places": proof.places,
                "cpu_seconds": round(sum(job.verdict.seconds for job in own), 1),
                "megabytes": round(max(job.verdict.megabytes for job in own)),
                "faults": [f"{job.label}: {job.fault()}" for job in own if job.fault()],
            }
        )
    return rows


def page(rows, seconds, passed, command, notes):
    """What ./dev writes to build/figures: tables in plain words."""
    return {
        "title": "What is proved of the flight code",
        "command": command,
        "seconds": round(seconds, 1),
        "passed": passed,
        "tables": [
            {
                "caption": "By the model checker ESBMC, over all values of the inputs; [what each says](../evidence.md#what-is-proved)",
                "columns": [
                    "proof",
                    "verdict",
                    "claims",
                    "seeded bugs refuted",
                    "places reached",
                    "CPU seconds",
                    "most memory in MB",
                ],
                "rows": [
                    [
                        row["name"],
                        "proved" if row["proved"] else "NOT PROVED",
                        str(row["claims"]),
                        f"{row['bugs_refuted']} of {row['bugs']}",
                        f"{row['places_reached']} of {row['places']}",
                        f"{row['cpu_seconds']:.1f}",
                        str(row["megabytes"]),
                    ]
                    for row in rows
                ],
            }
        ],
        "notes": [
            f"{sum(row['proved'] for row in rows)} of {len(rows)} properties proved: {sum(row['claims'] for row in rows)} claims, "
            f"{sum(row['bugs_refuted'] for row in rows)} of {sum(row['bugs'] for row in rows)} seeded bugs refuted.",
            "A property counts as proved only if each error that was put into a copy of the source was found, and "
            "each place of the harness was shown to be reachable.",
            *notes,
        ],
    }
