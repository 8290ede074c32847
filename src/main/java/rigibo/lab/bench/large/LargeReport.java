package rigibo.lab.bench.large;

import rigibo.lab.report.Amount;
import rigibo.lab.report.Table;

import java.util.List;

/** What bodies cost in worlds of very many, for a terminal and for a page. */
public final class LargeReport {

    private final List<LargeCosts> worlds;

    LargeReport(List<LargeCosts> worlds) {
        this.worlds = worlds;
    }

    /** For a terminal. */
    public List<String> text() {
        return table().text();
    }

    /** The measured part of a page of Markdown. */
    public String markdown(String provenance) {
        return provenance + "\n\n" + table().markdown();
    }

    private Table table() {
        return new Table(
                List.of(
                        "bodies",
                        "added",
                        "first step, a body",
                        "step, a body",
                        "slowest step",
                        "body at a point",
                        "snapshot, a body",
                        "removed",
                        "step asleep",
                        "memory, a body"),
                worlds.stream().map(LargeReport::row).toList());
    }

    private static List<String> row(LargeCosts world) {
        return List.of(
                "" + world.bodies(),
                Amount.time(world.add()),
                Amount.time(world.first() / world.bodies()),
                Amount.time(world.step() / world.bodies()),
                Amount.time(world.most()),
                Amount.time(world.ask()),
                Amount.time(world.snapshot() / world.bodies()),
                Amount.time(world.remove()),
                Amount.time(world.asleep()),
                Math.round(world.bytes()) + " B");
    }
}
