package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.Random;

/**
 * Elementary functions are within 1 unit in the last place of the truth. {@code
 * JAVA_TOOL_OPTIONS=-Drigibo.elementary.samples=1000000 ./rigibo test Elementary} asks for a
 * hundred times as many arguments, and prints the largest error.
 */
@Execution(ExecutionMode.CONCURRENT)
class ElementaryTest {

    private static final String ASKED = "rigibo.elementary.samples";
    private static final int SAMPLES = Integer.getInteger(ASKED, 10_000);

    /** The largest error that the Javadoc claims, in units in the last place. */
    private enum Function {
        SIN(0.85) {
            @Override
            double off(Random random) {
                double angle = angle(random);
                return Truth.offSine(angle, Angle.sin(angle));
            }
        },
        COS(0.85) {
            @Override
            double off(Random random) {
                double angle = angle(random);
                return Truth.offCosine(angle, Angle.cos(angle));
            }
        },
        ATAN2(0.6) {
            @Override
            double off(Random random) {
                double y = signed(random, -60, 60);
                double x = signed(random, -60, 60);
                double scale = Math.scalb(1.0, random.nextInt(1800) - 900);
                return Truth.offAngle(y, x, Angle.atan2(y * scale, x * scale));
            }
        },
        ASIN(0.6) {
            @Override
            double off(Random random) {
                double sine = share(random);
                return Truth.offAngleOfSine(sine, Angle.asin(sine));
            }
        },
        ACOS(0.6) {
            @Override
            double off(Random random) {
                double cosine = share(random);
                return Truth.offAngleOfCosine(cosine, Angle.acos(cosine));
            }
        },
        HYPOT(0.8) {
            @Override
            double off(Random random) {
                double x = signed(random, -1074, 1022);
                double y = x * signed(random, -55, -1);
                return Truth.offLength(y, x, Length.hypot(y, x));
            }
        },
        EXP(0.8) {
            @Override
            double off(Random random) {
                double x = power(random, 745, 709);
                return Truth.offPowerOfE(x, Exponential.exp(x));
            }
        },
        EXPM1(0.95) {
            @Override
            double off(Random random) {
                double x = power(random, 50, 709);
                return Truth.offPowerOfELessOne(x, Exponential.expm1(x));
            }
        },
        TANH(0.85) {
            @Override
            double off(Random random) {
                double x = power(random, 25, 25);
                return Truth.offHyperbolicTangent(x, Exponential.tanh(x));
            }
        },
        LOG(0.6) {
            @Override
            double off(Random random) {
                double x =
                        random.nextBoolean()
                                ? Math.abs(signed(random, -1074, 1023))
                                : 1 + signed(random, -50, -1);
                return Truth.offLogarithm(x, Logarithm.log(x));
            }
        },
        POW(0.8) {
            @Override
            double off(Random random) {
                double x = Math.abs(signed(random, -8, 8));
                double y = power(random, 745, 709) / StrictMath.log(x);
                return Truth.offPower(x, y, Logarithm.pow(x, y));
            }
        };

        private final double claimed;

        Function(double claimed) {
            this.claimed = claimed;
        }

        /** The error at an argument by chance, in units in the last place. */
        abstract double off(Random random);

        /** Of any size, of everyday size, or next to a multiple of π/2. */
        private static double angle(Random random) {
            return switch (random.nextInt(3)) {
                case 0 -> signed(random, -40, 1023);
                case 1 -> 20 * random.nextDouble() - 10;
                default -> {
                    double turns = Math.rint(signed(random, 0, 60));
                    double beside = turns * (Math.PI / 2);
                    yield random.nextBoolean() ? beside : Math.nextUp(beside);
                }
            };
        }

        /** A number from −1 to 1, also next to these and to 0. */
        private static double share(Random random) {
            double small = signed(random, -40, -1);
            return random.nextBoolean() ? small : Math.copySign(1 - Math.abs(small), small);
        }

        /** Evenly between two ends, or small. */
        private static double power(Random random, double least, double most) {
            double any = random.nextDouble();
            return random.nextBoolean() ? any * (least + most) - least : signed(random, -40, 3);
        }

        /** Its exponent even between two, both included. */
        private static double signed(Random random, int least, int most) {
            double fraction = 1 + random.nextDouble();
            double size = Math.scalb(fraction, least + random.nextInt(most - least + 1));
            return random.nextBoolean() ? size : -size;
        }
    }

    @ParameterizedTest
    @EnumSource
    void isWithinAUnitInTheLastPlace(Function function) {
        Random random = new Random(23);
        double worst = 0;
        for (int i = 0; i < SAMPLES; i++) {
            double off = function.off(random);
            worst = off > worst || off != off ? off : worst;
        }
        if (System.getProperty(ASKED) != null) {
            System.out.printf("%s: %.3f units in %,d arguments%n", function, worst, SAMPLES);
        }
        assertThat(worst).isLessThan(function.claimed);
    }
}
