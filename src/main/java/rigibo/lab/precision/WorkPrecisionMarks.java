package rigibo.lab.precision;

import rigibo.lab.engine.Line;
import rigibo.lab.plot.Box;
import rigibo.lab.plot.Label;
import rigibo.lab.plot.LabelPlacer;
import rigibo.lab.plot.Picture;
import rigibo.lab.plot.Plot;
import rigibo.lab.plot.Spot;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/** The lines, marks and names within a plot of error over cost. */
final class WorkPrecisionMarks {

    private static final double LINE_WIDTH = 1.8;
    private static final double PEER_LINE_WIDTH = 1.2;

    /** The distance between a mark and its name, px. */
    private static final double GAP = 3;

    /** The largest distance of the name of a preset or an engine from its mark, px. */
    private static final double FAR = 220;

    private final Asked asked;
    private final Picture picture;
    private final Plot plot;
    private final FigureSize size;
    private final LabelPlacer placer;

    /** The labels in the order in which room is found for them. */
    private final List<Name> names = new ArrayList<>();

    /** A label for whichever of some spots has room. */
    private record Name(Look look, String words, List<Spot> spots, double reach) {}

    WorkPrecisionMarks(
            Asked asked, Picture picture, Plot plot, FigureSize size, LabelPlacer placer) {
        this.asked = asked;
        this.picture = picture;
        this.plot = plot;
        this.size = size;
        this.placer = placer;
    }

    /** Draws all of it; names without room in the plot go into the key. */
    void draw(Key key) {
        List<Line> swept = asked.lines().stream().filter(Line::isSwept).toList();
        swept.forEach(line -> path(spots(asked.along(line)), LINE_WIDTH, Look.of(line)));
        swept.forEach(line -> marks(spots(asked.along(line)), Look.of(line)));
        List<Line> choices = asked.lines().stream().filter(line -> !line.isSwept()).toList();
        choices.forEach(line -> marks(spots(asked.along(line)), Look.of(line)));
        peers();
        presets();
        swept.forEach(this::nameLine);
        choices.forEach(this::nameChoices);
        names.forEach(name -> place(name, key));
    }

    private void path(List<Spot> spots, double width, Look look) {
        if (spots.size() > 1) {
            picture.path(spots, width, look.color());
        }
        for (int i = 1; i < spots.size(); i++) {
            placer.avoid(spots.get(i - 1), spots.get(i));
        }
    }

    private void marks(List<Spot> spots, Look look) {
        for (Spot spot : spots) {
            look.draw(picture, spot);
            placer.keepFree(Box.around(spot.x(), spot.y(), look.radius()));
        }
    }

    private void peers() {
        List<String> peers = asked.peers();
        for (int i = 0; i < peers.size(); i++) {
            Look look = Look.peer(i);
            List<Spot> spots = spots(asked.of(peers.get(i)));
            path(spots, PEER_LINE_WIDTH, look);
            marks(spots, look);
            name(look, peers.get(i), spots, FAR);
        }
    }

    private void presets() {
        Look look = Look.of(Line.PRESETS);
        for (Point preset : drawn(asked.presets())) {
            marks(List.of(spot(preset)), look);
            name(look, preset.setting().name(), List.of(spot(preset)), FAR);
        }
    }

    private void nameLine(Line line) {
        String more = ObservedOrder.isObservedOf(line) ? orderAlong(line) : "";
        name(Look.of(line), line.words() + more, spots(asked.along(line)), size.reach());
    }

    /** The observed order; none if errors rise and fall alternately. */
    private String orderAlong(Line line) {
        List<Point> points = asked.along(line);
        ObservedOrder order = ObservedOrder.of(points);
        return switch (order.verdict(line, points)) {
            case AS_EXPECTED, HIGHER, LOWER, SOME ->
                    String.format(Locale.ROOT, ": order %.1f", order.median());
            case FLAT -> ": flat";
            case RISING -> ": rising";
            case IRREGULAR, EXACT, NOT_KNOWN -> "";
        };
    }

    private void nameChoices(Line line) {
        for (Point choice : drawn(asked.along(line))) {
            String words = choice.setting().name();
            name(Look.of(line), words, List.of(spot(choice)), size.reach());
        }
    }

    private void name(Look look, String words, List<Spot> spots, double reach) {
        if (!spots.isEmpty()) {
            names.add(new Name(look, words, spots, reach));
        }
    }

    /** A label is better near any of its spots than far from the first. */
    private void place(Name name, Key key) {
        Look look = name.look();
        double gap = look.radius() + GAP;
        for (double reach : new double[] {gap, name.reach() / 4, name.reach()}) {
            for (Spot spot : name.spots()) {
                String color = look.wordsColor();
                Label label = new Label(name.words(), size.words(), color, spot, gap, reach);
                if (placer.place(picture, label)) {
                    return;
                }
            }
        }
        key.add(look, name.words());
    }

    private List<Point> drawn(List<Point> points) {
        return points.stream()
                .filter(point -> point.cost() > 0 && !point.errors().hasFailed())
                .sorted(Comparator.comparingDouble(point -> point.setting().at()))
                .toList();
    }

    private Spot spot(Point point) {
        return plot.at(point.cost(), point.errors().main());
    }

    private List<Spot> spots(List<Point> points) {
        return drawn(points).stream().map(this::spot).toList();
    }
}
