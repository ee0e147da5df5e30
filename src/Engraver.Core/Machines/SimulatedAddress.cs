using System.Globalization;

namespace Engraver.Core.Machines;

/// <param name="Speed">Controller seconds per wall second; infinity is virtual time.</param>
public sealed record SimulatedAddress(double Speed) : ControllerAddress
{
    /// <summary>False for <c>sim:</c> without a speed: the connect command then uses the speed of its session.</summary>
    public bool HasExplicitSpeed { get; init; } = true;

    public override string Typed => double.IsPositiveInfinity(Speed) ? "sim:" : string.Create(CultureInfo.InvariantCulture, $"sim:?speed={Speed}");
}
