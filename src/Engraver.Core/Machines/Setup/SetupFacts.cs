namespace Engraver.Core.Machines.Setup;

/// <summary>The controller's settings of its wiring. Null for a value that it does not report, or that has no name here.</summary>
/// <param name="LimitSense">Level at which a limit switch counts as hit, one for all axes.</param>
/// <param name="HomeSense">How the home inputs are read, one for all axes.</param>
/// <param name="Axes">In the requested order.</param>
public sealed record SetupFacts(SwitchSense? LimitSense, SwitchSense? HomeSense, IReadOnlyList<AxisFacts> Axes)
{
    /// <exception cref="InvalidOperationException">That axis was not requested.</exception>
    public AxisFacts this[char letter] => Axes.First(axis => axis.Letter == letter);
}
