package rigibo.lab.precision;

import rigibo.lab.child.Kept;
import rigibo.lab.crowd.CrowdFigure;
import rigibo.lab.crowd.CrowdPoint;
import rigibo.lab.crowd.Crowds;
import rigibo.lab.energy.BouncingBall;
import rigibo.lab.energy.EnergyFigure;
import rigibo.lab.energy.EnergyTrace;
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
import rigibo.lab.report.Section;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** The figures beside those of single problems; only in a report of all problems. */
final class MoreFigures {

    private final Inquiry inquiry;
    private final Kept kept;
    private final Consumer<String> tell;

    MoreFigures(Inquiry inquiry, Kept kept, Consumer<String> tell) {
        this.inquiry = inquiry;
        this.kept = kept;
        this.tell = tell;
    }

    /** Measures what they show, as much as was asked for. */
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
        EnergyFigure wide = new EnergyFigure(ours, others, FigureSize.WIDE.width());
        EnergyFigure narrow = new EnergyFigure(ours, others, FigureSize.NARROW.width());
        return new Section(
                "energy",
                "Energy over time",
                wide.sentences(),
                List.of(wide.drawing(), narrow.drawing()),
                List.of());
    }

    private Section crowd() {
        tell.accept("floods of every size");
        boolean isFull = inquiry.extent() == Extent.FULL;
        List<CrowdPoint> points = (isFull ? Crowds.full() : Crowds.quick()).pour(kept, tell);
        CrowdFigure wide = new CrowdFigure(points, FigureSize.WIDE.width());
        CrowdFigure narrow = new CrowdFigure(points, FigureSize.NARROW.width());
        return new Section(
                "bodies",
                "Bodies against step time",
                wide.sentences(),
                List.of(wide.drawing(), narrow.drawing()),
                List.of());
    }

    private Section margins() {
        tell.accept("hard cases");
        Cases cases = new Cases(List.of(), List.of(Preset.values()), Sampling.USUAL);
        List<Margin> margins = Margins.of(cases, inquiry.out()).find(tell);
        MarginFigure wide = new MarginFigure(margins, FigureSize.WIDE.width());
        MarginFigure narrow = new MarginFigure(margins, FigureSize.NARROW.width());
        return new Section(
                "cases",
                "Hard cases",
                wide.sentences(),
                List.of(wide.drawing(), narrow.drawing()),
                List.of());
    }
}
