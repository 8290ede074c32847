/**
 * The demos: each shows one side of the physics, with controls and readouts. A {@link
 * rigibo.frontend.demo.Demo} states only its own part; {@link rigibo.frontend.demo.DemoScene} gives
 * it a workbench, a panel and the keys that all demos share.
 */
package rigibo.frontend.demo;
