package rigibo.backend.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;

/** Readers always read one whole picture, and the maker always finds a free one. */
@Timeout(60)
class ExchangeTest {

    private static final int NUMBERS = 64;

    private final Exchange<long[]> exchange = new Exchange<>(() -> new long[NUMBERS]);

    private void publish(long number) {
        Arrays.fill(exchange.draw(), number);
        exchange.publish();
    }

    private static long number(Lease<long[]> lease) {
        long[] picture = lease.picture();
        assertThat(picture).containsOnly(picture[0]);
        return picture[0];
    }

    @Test
    void twoPicturesAreEnoughWhereNobodyReads() {
        for (int i = 0; i < 100; i++) {
            publish(i);
            try (Lease<long[]> lease = exchange.take()) {
                assertThat(number(lease)).isEqualTo(i);
            }
        }
        assertThat(exchange.pictures()).isEqualTo(2);
    }

    /** Half a picture is drawn when it is asked for: it is the former one that is told. */
    @Test
    void whatIsBeingDrawnIsNotSeen() {
        publish(1);
        Arrays.fill(exchange.draw(), 0, NUMBERS / 2, 2);
        try (Lease<long[]> lease = exchange.take()) {
            assertThat(number(lease)).isEqualTo(1);
            publish(2);
            publish(3);
            assertThat(number(lease)).isEqualTo(1);
        }
    }

    /** Each reader holds a picture of its own, and for as long as it likes. */
    @Test
    void asManyPicturesAreMadeAsAreOpenAndTwo() {
        List<Lease<long[]>> open = new ArrayList<>();
        for (int i = 0; i < Exchange.MOST_OPEN; i++) {
            publish(i);
            open.add(exchange.take());
        }
        publish(-1);
        publish(-2);
        assertThat(exchange.pictures()).isEqualTo(Exchange.MOST_OPEN + 2);
        for (int i = 0; i < open.size(); i++) {
            assertThat(number(open.get(i))).isEqualTo(i);
        }
        assertThatIllegalStateException()
                .isThrownBy(exchange::take)
                .withMessageContaining("at most " + Exchange.MOST_OPEN + " pictures");
        open.get(7).close();
        try (Lease<long[]> lease = exchange.take()) {
            assertThat(number(lease)).isEqualTo(-2);
        }
        publish(-3);
        assertThat(exchange.pictures()).isEqualTo(Exchange.MOST_OPEN + 2);
    }

    /** Readers come and go in any order: none of them sees its picture change. */
    @Test
    void anyOrderOfReadersAndPicturesIsTold() {
        SplittableRandom random = new SplittableRandom(5);
        List<Lease<long[]>> open = new ArrayList<>();
        List<Long> expected = new ArrayList<>();
        int mostOpen = 0;
        long newest = 0;
        publish(newest);
        for (int i = 0; i < 20_000; i++) {
            int what = random.nextInt(3);
            if (what == 0) {
                publish(++newest);
            } else if (what == 1 && open.size() < 9) {
                open.add(exchange.take());
                expected.add(newest);
            } else if (!open.isEmpty()) {
                int one = random.nextInt(open.size());
                assertThat(number(open.get(one))).as("step %d", i).isEqualTo(expected.get(one));
                open.remove(one).close();
                expected.remove(one);
            }
            mostOpen = Math.max(mostOpen, open.size());
            assertThat(exchange.pictures()).isLessThanOrEqualTo(mostOpen + 2);
        }
        assertThat(mostOpen).isEqualTo(9);
    }

    /**
     * Four readers check that all numbers of a picture are one, and that no picture is older than
     * the one before; the maker goes on until each has read 20,000 pictures, and they until they
     * have read its twenty thousandth.
     */
    @Test
    void readersOfManyThreadsSeeWholePicturesInOrder() {
        int readings = 20_000;
        AtomicLong made = new AtomicLong();
        publish(0);
        List<CompletableFuture<Void>> readers = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            readers.add(
                    CompletableFuture.runAsync(() -> read(readings, made), ExchangeTest::start));
        }
        CompletableFuture<Void> all =
                CompletableFuture.allOf(readers.toArray(new CompletableFuture<?>[0]));
        while (!all.isDone()) {
            publish(made.get() + 1);
            made.incrementAndGet();
        }
        all.join();
        assertThat(exchange.pictures()).isBetween(2, 4 + 2);
    }

    /** Threads of their own: a pool of them might have too few. */
    private static void start(Runnable reader) {
        Thread thread = new Thread(reader, "reader");
        thread.setDaemon(true);
        thread.start();
    }

    private void read(int readings, AtomicLong made) {
        long last = -1;
        for (int i = 0; i < readings || last < readings; i++) {
            long before = made.get();
            try (Lease<long[]> lease = exchange.take()) {
                long[] picture = lease.picture();
                long number = picture[0];
                for (long other : picture) {
                    if (other != number) {
                        throw new AssertionError("torn: " + Arrays.toString(picture));
                    }
                }
                if (number < last || number < before) {
                    throw new AssertionError(number + " after " + last + ", of " + before);
                }
                last = number;
            }
        }
    }

    @Test
    void misuseIsRefused() {
        publish(1);
        Lease<long[]> lease = exchange.take();
        assertThatIllegalStateException()
                .isThrownBy(() -> onAnotherThread(lease::picture))
                .withMessageContaining("is for the thread that took it");
        assertThatIllegalStateException()
                .isThrownBy(() -> onAnotherThread(lease::close))
                .withMessageContaining("is for the thread that took it");
        lease.close();
        assertThatIllegalStateException()
                .isThrownBy(lease::picture)
                .withMessageContaining("was closed");
        assertThatIllegalStateException()
                .isThrownBy(lease::close)
                .withMessageContaining("was closed");
        // A refused call gives nothing back: this picture is free, and no other.
        publish(2);
        publish(3);
        assertThat(exchange.pictures()).isEqualTo(2);
    }

    private static void onAnotherThread(Runnable work) {
        RuntimeException[] thrown = new RuntimeException[1];
        Thread other =
                new Thread(
                        () -> {
                            try {
                                work.run();
                            } catch (RuntimeException refused) {
                                thrown[0] = refused;
                            }
                        });
        other.start();
        try {
            other.join();
        } catch (InterruptedException interrupted) {
            throw new AssertionError(interrupted);
        }
        if (thrown[0] != null) {
            throw thrown[0];
        }
    }

    @Test
    void whatIsOpenAtTheCloseMayBeReadOn() {
        publish(1);
        Lease<long[]> lease = exchange.take();
        exchange.close();
        assertThat(exchange.isClosed()).isTrue();
        assertThatIllegalStateException()
                .isThrownBy(exchange::take)
                .withMessageContaining("the pool was closed");
        assertThat(number(lease)).isEqualTo(1);
        lease.close();
    }
}
