package rigibo;

import com.sun.management.GarbageCollectionNotificationInfo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.Monkey;
import rigibo.frontend.scene.DisplayException;

import java.io.PrintWriter;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;

import javax.management.Notification;
import javax.management.NotificationEmitter;
import javax.management.openmbean.CompositeData;

/** Lets a monkey play, and tells what became of the process. */
@Command(
        name = "monkey",
        description =
                "Random input in real windows: nothing may be thrown, OpenGL may not complain, and"
                        + " memory may not grow.")
final class MonkeyCommand implements Callable<Integer> {

    private static final int TURNS_PER_MINUTE = 3600;
    private static final double MOST_MINUTES = 24 * 60;

    /** Of the heap after a collection, MB: caches that fill once are no leak. */
    private static final double MOST_GROWTH = 16;

    private static final double MEGABYTE = 1 << 20;

    /** The cause of the collections that only find out what is in use. */
    private static final String OURS = "System.gc()";

    /** What collectors that work beside the game call their work, which is no pause. */
    private static final String BESIDE = "Cycles";

    @Option(
            names = "--minutes",
            paramLabel = "M",
            defaultValue = "10",
            description = "How long it plays, 10 unless said otherwise.")
    private double minutes;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "The same seed does the same, 1 unless said otherwise.")
    private long seed;

    @Spec private CommandSpec spec;

    /** ms; collections are told of on a thread of their own. */
    private final AtomicLong longestPause = new AtomicLong();

    @Override
    public Integer call() {
        if (!(minutes > 0 && minutes <= MOST_MINUTES)) {
            String range = "must be more than 0 and at most " + (int) MOST_MINUTES;
            throw Options.refused(spec, "--minutes", range + ", was " + minutes);
        }
        PrintWriter out = spec.commandLine().getOut();
        listen();
        int turns = (int) Math.max(2, minutes * TURNS_PER_MINUTE);
        try {
            // A fifth of it fills what is filled once: classes, caches, fonts.
            Monkey.Report first = Monkey.play(Catalog::menu, Catalog.entries(), turns / 5, seed);
            double before = heap();
            Monkey.Report rest =
                    Monkey.play(Catalog::menu, Catalog.entries(), turns - turns / 5, seed + 1);
            double growth = heap() - before;
            out.printf(
                    "%d turns in %d windows: %d complaints, the heap grew from %.1f by %.1f MB,"
                            + " pauses for garbage took %d ms at most%n",
                    first.turns() + rest.turns(),
                    first.windows() + rest.windows(),
                    first.troubles().size() + rest.troubles().size(),
                    before,
                    growth,
                    longestPause.get());
            first.troubles().forEach(out::println);
            rest.troubles().forEach(out::println);
            boolean isSound = first.troubles().isEmpty() && rest.troubles().isEmpty();
            return isSound && growth <= MOST_GROWTH ? 0 : 1;
        } catch (DisplayException e) {
            spec.commandLine().getErr().println(e.getMessage());
            return 1;
        }
    }

    /** What is in use when everything that can go is gone, MB. */
    private static double heap() {
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        return (runtime.totalMemory() - runtime.freeMemory()) / MEGABYTE;
    }

    /** Notes how long collections take that the game caused, ms. */
    private void listen() {
        for (GarbageCollectorMXBean collector : ManagementFactory.getGarbageCollectorMXBeans()) {
            if (!collector.getName().endsWith(BESIDE)) {
                ((NotificationEmitter) collector)
                        .addNotificationListener((told, nothing) -> note(told), null, null);
            }
        }
    }

    private void note(Notification told) {
        var info = GarbageCollectionNotificationInfo.from((CompositeData) told.getUserData());
        if (!info.getGcCause().equals(OURS)) {
            longestPause.accumulateAndGet(info.getGcInfo().getDuration(), Math::max);
        }
    }
}
