package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Widget;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;

/** Links carry the settings of controls from one demo to another. */
class ChoicesTest {

    static Stream<Function<Words, Demo>> demos() {
        return EveryDemo.all();
    }

    private static List<Widget> linked(Demo demo) {
        return demo.widgets().stream().filter(any -> !any.linked().isEmpty()).toList();
    }

    @ParameterizedTest
    @MethodSource("demos")
    void everyControlIsAsItWas(Function<Words, Demo> maker) {
        Demo sent = maker.apply(new Words("en"));
        EveryDemo.built(sent);
        Choices choices = new Choices(sent.widgets());
        assertThat(choices.in(Link.to("any"))).isEqualTo(Link.to("any"));
        linked(sent).forEach(widget -> widget.nudge(1));
        Link link = Link.of(choices.in(Link.to("any")).text());
        Demo opened = maker.apply(new Words("de"));
        EveryDemo.built(opened);
        int taken = new Choices(opened.widgets()).follow(link);
        assertThat(taken).isEqualTo(linked(sent).size()).isEqualTo(link.choices().size());
        assertThat(linked(opened).stream().map(Widget::setting))
                .isEqualTo(linked(sent).stream().map(Widget::setting).toList());
    }

    @ParameterizedTest
    @MethodSource("demos")
    void controlsHaveNamesOfTheirOwn(Function<Words, Demo> maker) {
        Demo demo = maker.apply(new Words("en"));
        EveryDemo.built(demo);
        Set<String> names = new HashSet<>(Set.of("accuracy", "ghost"));
        assertThat(linked(demo)).isNotEmpty().allMatch(any -> names.add(any.linked()));
    }

    /** Its controls apply to what is stacked next. */
    @Test
    void cratesAreStackedAsTheLinkSays() {
        Demo demo = new CrateDemo(new Words("en"));
        Pool pool = EveryDemo.built(demo).pool();
        new Choices(demo.widgets()).follow(Link.of("crate?mass=20"));
        demo.followed();
        List<RigidBody> crates =
                pool.bodies().stream().filter(any -> any.mass() > 19 && any.mass() < 21).toList();
        assertThat(crates).hasSize(10);
    }
}
