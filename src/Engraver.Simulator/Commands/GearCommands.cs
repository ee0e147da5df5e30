using Engraver.Simulator.Language;
using Engraver.Simulator.Motion;

namespace Engraver.Simulator.Commands;

/// <summary>GA names the master of each axis (galil-dmc.md B.6): <c>GAC=S</c> or <c>GA ,,S</c>. GR and GM are settings of the axes.</summary>
internal static class GearCommands
{
    public static IEnumerable<CommandEntry> Entries { get; } = [new("GA", CommandScope.Both, SetMasters, TakesLetter: true)];

    private static void SetMasters(StatementReader reader)
    {
        if (reader.Next == '~' || reader.Rest is [_, '=', ..])
        {
            var index = AxisSelection.IndexOf(reader.TakeLetter());
            reader.Take('=', Tc.OperandError);
            SetMaster(reader, index);
        }
        else
        {
            for (var index = 0; !reader.IsAtEnd; index++)
            {
                if (reader.Next != ',') SetMaster(reader, index);
                if (!reader.TryTake(',')) break;
            }
        }

        reader.ExpectEnd();
    }

    private static void SetMaster(StatementReader reader, int index)
    {
        if (index is < 0 or >= Axis.Real) throw new CommandRefusedException(Tc.BadAxis);
        var master = reader.TakeLetter();
        if (master is not ('S' or 'T') && AxisSelection.IndexOf(master) is var number && (number < 0 || number == index))
            throw new CommandRefusedException(number == index ? Tc.MasterAndFollower : Tc.OperandError);
        reader.Machine.Motion.Axes[index].Gear.Master = master;
    }
}
