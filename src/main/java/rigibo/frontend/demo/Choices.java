package rigibo.frontend.demo;

import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.widget.Widget;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The settings of a demo's controls, as links carry them. */
final class Choices {

    private final List<Widget> widgets;
    private final Map<String, String> first;

    /** The controls of a demo that was just built. */
    Choices(List<Widget> widgets) {
        this.widgets = widgets.stream().filter(widget -> !widget.linked().isEmpty()).toList();
        first = settings();
    }

    private Map<String, String> settings() {
        Map<String, String> settings = new LinkedHashMap<>();
        widgets.forEach(widget -> settings.put(widget.linked(), widget.setting()));
        return settings;
    }

    /**
     * Returns a link with the choices. It states all controls, since one may set another, or none
     * if none was touched.
     */
    Link in(Link link) {
        Map<String, String> settings = settings();
        Link all = link;
        if (!settings.equals(first)) {
            for (Map.Entry<String, String> one : settings.entrySet()) {
                all = all.with(one.getKey(), one.getValue());
            }
        }
        return all;
    }

    /** Sets each control that a link names, in the order of the panel; returns how many took it. */
    int follow(Link link) {
        int taken = 0;
        for (Widget widget : widgets) {
            String setting = link.choices().get(widget.linked());
            if (setting != null && widget.set(setting)) {
                taken++;
            }
        }
        return taken;
    }
}
