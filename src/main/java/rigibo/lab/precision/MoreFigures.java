package rigibo.lab.precision;

import rigibo.lab.bench.crowd.CrowdFigure;
import rigibo.lab.bench.crowd.CrowdPoint;
import rigibo.lab.bench.crowd.Crowds;
import rigibo.lab.child.Kept;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.Setting;
import rigibo.lab.hardcase.Cases;
import rigibo.lab.hardcase.Margin;
import rigibo.lab.hardcase.MarginFigure;
import rigibo.lab.hardcase.Margins;
import rigibo.lab.hardcase.Preset;
import rigibo.lab.hardcase.Sampling;
import rigibo.lab.plot.Drawing;
import rigibo.lab.report.Section;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;

/** The figures that are not about a single problem; only a report of all problems has them. */
final class MoreFigures {

    private final Inquiry inquiry;
    private final Kept kept;
    private final Consumer<String> tell;

    MoreFigures(Inquiry inquiry, Kept kept, Consumer<String> tell) {
        this.inquiry = inquiry;
        this.kept = kept;
        this.tell = tell;
    }

    /** Measures what the figures show, to the extent asked for. */
    List<Section> sections() {
        if (!inquiry.problems().equals(Inquiry.problemIds())) {
            return List.of();
        }
        List<Section> sections = new ArrayList<>();
        sections.add(energy());
        sections.add(crowd());
        if (inquiry.extent() == Extent.FULL) {
            sections.add(margins());
        }
        return sections;
    }

    private static Section energy() {
        List<EnergyTrace> ours = new ArrayList<>();
        List<EnergyTrace> others = new ArrayList<>();
        for (Engine engine : Engines.all()) {
            List<Setting> settings = engine.settings();
            settings.stream()
                    .filter(setting -> setting.line() == Line.PRESETS)
                    .forEach(preset -> ours.add(BouncingBall.trace(engine, preset)));
            if (settings.get(0).line() == Line.PEERS) {
                others.add(BouncingBall.trace(engine, settings.get(0)));
            }
        }
        EnergyFigure figure = new EnergyFigure(ours, others);
        return section("energy", "Energy over time", figure.sentences(), figure::drawing);
    }

    private Section crowd() {
        tell.accept("floods of every size");
        boolean isFull = inquiry.extent() == Extent.FULL;
        List<CrowdPoint> points = (isFull ? Crowds.full() : Crowds.quick()).pour(kept, tell);
        CrowdFigure figure = new CrowdFigure(points);
        return section("bodies", "Bodies against step time", figure.sentences(), figure::drawing);
    }

    private Section margins() {
        tell.accept("hard cases");
        Cases cases = new Cases(List.of(), List.of(Preset.values()), Sampling.USUAL);
        List<Margin> margins = Margins.of(cases, inquiry.out(), tell);
        MarginFigure figure = new MarginFigure(margins);
        return section("cases", "Hard cases", figure.sentences(), figure::drawing);
    }

    /** A section whose figure is drawn for a width in px. */
    private static Section section(
            String name, String title, List<String> sentences, DoubleFunction<Drawing> figure) {
        List<Drawing> drawings =
                List.of(
                        figure.apply(FigureSize.WIDE.width()),
                        figure.apply(FigureSize.NARROW.width()));
        return new Section(name, title, sentences, drawings, List.of());
    }
}
