package rigibo.lab.plot;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

class LabelPlacerTest {

    private static final Box BOUNDS = new Box(0, 0, 600, 400);

    @Test
    void labelsOfACrowdKeepApart() {
        SplittableRandom random = new SplittableRandom(7);
        LabelPlacer placer = new LabelPlacer(BOUNDS);
        Seen seen = new Seen();
        List<Box> marks = new ArrayList<>();
        for (int i = 0; i < 30; i++) {
            Spot spot = new Spot(random.nextDouble(50, 250), random.nextDouble(50, 250));
            marks.add(Box.around(spot.x(), spot.y(), 4));
        }
        marks.forEach(placer::keepFree);
        for (Box mark : marks) {
            Spot of = new Spot(mark.left() + 4, mark.top() + 4);
            placer.place(seen, new Label("substeps 16", 13, Palette.INK, of, 6, 300));
        }
        assertThat(seen.texts()).hasSizeGreaterThan(20);
        assertThat(seen.overlaps()).isEmpty();
        assertThat(seen.texts()).allMatch(text -> BOUNDS.holds(text.box()));
        assertThat(seen.texts()).noneMatch(text -> marks.stream().anyMatch(text.box()::overlaps));
    }

    @Test
    void labelStepsAsideForALine() {
        LabelPlacer placer = new LabelPlacer(BOUNDS);
        placer.avoid(new Spot(300, 200), new Spot(600, 200));
        Seen seen = new Seen();
        placer.place(seen, new Label("on a line", 13, Palette.INK, new Spot(300, 200), 6, 100));
        Box box = seen.texts().get(0).box();
        assertThat(box.overlaps(new Box(300, 199, 600, 201))).isFalse();
    }

    @Test
    void labelWithoutRoomIsRefused() {
        LabelPlacer placer = new LabelPlacer(new Box(0, 0, 40, 40));
        Seen seen = new Seen();
        Label label = new Label("longer than that", 13, Palette.INK, new Spot(20, 20), 6, 100);
        assertThat(placer.place(seen, label)).isFalse();
        assertThat(seen.texts()).isEmpty();
    }
}
