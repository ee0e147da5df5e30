using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>HM, FE, FI wait for BG (galil-dmc.md C.2); AL arms a latch (C).</summary>
internal static class HomingCommands
{
    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("HM", CommandScope.Both, r => Prepare(r, AxisMove.Home)),
        new("FE", CommandScope.Both, r => Prepare(r, AxisMove.FindEdge)),
        new("FI", CommandScope.Both, r => Prepare(r, AxisMove.FindIndex)),
        new("AL", CommandScope.Both, ArmLatches),
    ];

    private static void Prepare(StatementReader reader, AxisMove move)
    {
        Axis[] axes = [.. reader.TakeAxes().AxesOrAll];
        if (Array.Exists(axes, reader.Machine.Motion.IsBusy)) throw new CommandRefusedException(Tc.NotWhileRunning);
        foreach (var axis in axes) axis.NextMove = move;
    }

    /// <summary>ALAB arms the latches of A and B on their inputs, ALTA that of A on its index pulse.</summary>
    private static void ArmLatches(StatementReader reader)
    {
        var index = reader.TryTake('T');
        foreach (var axis in reader.TakeAxes().AxesOrAll) axis.Latch.Arm(index);
    }
}
