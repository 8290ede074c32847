/**
 * Bodies in flight: they follow their exact paths whatever the length of the step, and their
 * impacts with each other and with everything else are resolved in time order.
 */
package rigibo.backend.flight;
