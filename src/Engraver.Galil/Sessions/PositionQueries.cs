using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Queries a controller's position and whether it still counts from the same zero: its position, serial number, clock and the mark that a session
/// stored in a variable. The variable is lost at power-off unless it is burned with BV (galil-dmc.md A.6); a clock that runs backwards shows that.</summary>
internal static class PositionQueries
{
    /// <summary>A name that no other program uses; at most eight characters (galil-dmc.md E).</summary>
    private const string MarkVariable = "cncmark";

    /// <param name="letters">The axes of the controller.</param>
    /// <param name="axes">The axes that move the drawing's X and Y.</param>
    /// <exception cref="ControllerException">The link failed, or the controller cannot report its position.</exception>
    public static async ValueTask<ControllerPosition> AskAsync(CommandChannel channel, string letters, MachineAxes axes, CancellationToken cancellation)
    {
        if (axes.Letters.Except(letters).ToList() is { Count: > 0 } missing) return new ControllerPosition(default, Doubt: Wording.Get("PositionQueries.NoSuchAxis", string.Join(", ", missing), letters));
        var position = await channel.ReadAsync(string.Join(',', axes.Letters.Select(letter => $"_RP{letter}")), cancellation).ConfigureAwait(false);
        if (position.Refusal is { } refused) throw new ProtocolViolationException(refused.Explain());
        async ValueTask<double?> Ask(string operand) => (await channel.ReadAsync(operand, cancellation).ConfigureAwait(false)).ValuesOrEmpty;
        var serial = await Ask("_BN").ConfigureAwait(false);
        var mark = await Ask(MarkVariable).ConfigureAwait(false);
        var clock = await Ask("TIME").ConfigureAwait(false);
        var (steppers, untold) = await SteppersAsync(axes, Ask).ConfigureAwait(false);
        var steppersOff = await LettersWhereAsync(steppers, "_MO", value => value == 1.0, Ask).ConfigureAwait(false);
        var stoppedHard = await LettersWhereAsync(steppers, "_SC", value => StopCodes.IsWithoutRamp((int)value), Ask).ConfigureAwait(false);
        return new ControllerPosition(
            CountsPoint.From([.. position.Values]),
            serial is > 0 ? (long)serial : null,
            mark is > 0 ? (int)mark : null,
            clock,
            steppersOff.Length == 0 ? "" : Wording.Get("PositionQueries.SteppersOff", string.Join(", ", axes.NamesOf(steppersOff).AsEnumerable()))) { Letters = axes.Letters, WithoutEncoder = steppers, AssumedSteppers = untold, StoppedWithoutRamp = stoppedHard };
    }

    /// <summary>The same over the stop handle, independent of what the operator does meanwhile.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public static ValueTask<ControllerPosition> AskAsync(ControllerSession session, MachineAxes axes) => AskAsync(session.StopHandle, session.Identity.Letters, axes, CancellationToken.None);

    /// <summary>The assignment creates the variable.</summary>
    /// <returns>False when the controller has no room for another variable.</returns>
    public static async ValueTask<bool> MarkAsync(CommandChannel channel, int mark, CancellationToken cancellation) =>
        await channel.SendAsync(string.Create(CultureInfo.InvariantCulture, $"{MarkVariable}={mark}"), cancellation).ConfigureAwait(false) is Accepted;

    /// <summary>The position of a servo without current is still counted by its encoder, that of a stepper is not. _MT is 2, -2, 2.5 or -2.5 for a stepper
    /// (galil-dmc.md C), with decimals or without. If the controller does not support _MT, the profile is used; without either the axis counts as a stepper,
    /// which guarantees less.</summary>
    /// <returns>The letters of all of them, and of those whose motor type is assumed.</returns>
    private static async ValueTask<(string All, string Untold)> SteppersAsync(MachineAxes axes, Func<string, ValueTask<double?>> ask)
    {
        var (steppers, untold) = ("", "");
        foreach (var axis in axes.All)
        {
            var type = await ask($"_MT{axis.Letter}").ConfigureAwait(false) ?? axis.MotorType;
            if (type is null) untold += axis.Letter;
            if (type is not { } known || (axis with { MotorType = known }).IsStepper) steppers += axis.Letter;
        }

        return (steppers, untold);
    }

    /// <returns>The letters of the axes whose value fulfils the condition; an axis without a value does not.</returns>
    private static async ValueTask<string> LettersWhereAsync(string axes, string operand, Func<double, bool> isSo, Func<string, ValueTask<double?>> ask)
    {
        var those = "";
        foreach (var axis in axes)
        {
            if (await ask(operand + axis).ConfigureAwait(false) is { } value && isSo(value)) those += axis;
        }

        return those;
    }
}
