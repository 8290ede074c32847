/**
 * The demos: each shows one side of the physics, with controls and readouts. A {@link
 * rigibo.frontend.demo.Demo} says only what it is; {@link rigibo.frontend.demo.DemoScene} gives it
 * a workbench, a panel and the keys that all of them share.
 */
package rigibo.frontend.demo;
