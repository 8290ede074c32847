package rigibo.lab.bench.large;

import rigibo.lab.report.Amount;
import rigibo.lab.report.Report;
import rigibo.lab.report.Table;

import java.util.List;

/** Reports what bodies cost in very large worlds. */
final class LargeReport {

    private LargeReport() {}

    static Report of(List<LargeCosts> worlds) {
        return Report.of(
                new Table(
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
                        worlds.stream().map(LargeReport::row).toList()),
                List.of());
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
