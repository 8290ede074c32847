package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.widget.Widget;

import java.util.List;
import java.util.Optional;

/**
 * The accuracy of one world in links: {@code left=fine}, and where sliders set one of its own, each
 * of those, {@code left-substeps=12}.
 *
 * @param name of the half
 * @param half whose accuracy it is
 * @param sliders that set it
 */
record LinkedHalf(String name, Half half, List<Widget> sliders) {

    /** Returns a link with the accuracy. */
    Link in(Link link) {
        Link all = link.with(name, half.preset().linked());
        if (half.isOwn()) {
            for (Widget slider : sliders) {
                all = all.with(linked(slider), slider.setting());
            }
        }
        return all;
    }

    /** Sets what a link names; returns how many choices that were. */
    int follow(Link link) {
        Optional<Preset> named = Preset.ofLinked(link.choices().getOrDefault(name, ""));
        named.ifPresent(half::choose);
        int taken = named.isPresent() ? 1 : 0;
        for (Widget slider : sliders) {
            String setting = link.choices().get(linked(slider));
            if (setting != null && slider.set(setting)) {
                taken++;
            }
        }
        return taken;
    }

    private String linked(Widget slider) {
        return name + "-" + slider.linked();
    }
}
