using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>GA names the master of each axis (galil-dmc.md B.6): <c>GAC=S</c> or <c>GA ,,S</c>; the query <c>GAC=?</c> or <c>GA ,,?</c> replies with its
/// letter, 0 for none [U]. GR and GM are settings of the axes.</summary>
internal static class GearCommands
{
    public static IEnumerable<CommandEntry> Entries { get; } = [new("GA", CommandScope.Both, SetMasters, TakesLetter: true)];

    private static void SetMasters(StatementReader reader)
    {
        var asked = new List<string>();
        if (reader.Next == '~' || reader.Rest is [_, '=', ..])
        {
            var index = AxisSelection.IndexOf(reader.TakeLetter());
            reader.Take('=', Tc.OperandError);
            TakeMaster(reader, index, asked);
        }
        else
        {
            for (var index = 0; !reader.IsAtEnd; index++)
            {
                if (reader.Next != ',') TakeMaster(reader, index, asked);
                if (!reader.TryTake(',')) break;
            }
        }

        reader.ExpectEnd();
        if (asked.Count > 0) reader.Context.WriteLine(ReportCommands.Join(asked));
    }

    private static void TakeMaster(StatementReader reader, int index, List<string> asked)
    {
        if (index is < 0 or >= Axis.Real) throw new CommandRefusedException(Tc.BadAxis);
        if (reader.IsAtEnd || reader.TryTake('?'))
        {
            asked.Add(" " + (reader.Machine.Motion.Axes[index].Gear.Master is var present and not ' ' ? present : '0'));
            return;
        }

        var master = reader.TakeLetter();
        if (master is not ('S' or 'T') && AxisSelection.IndexOf(master) is var number && (number < 0 || number == index))
            throw new CommandRefusedException(number == index ? Tc.MasterAndFollower : Tc.OperandError);
        reader.Machine.Motion.Axes[index].Gear.Master = master;
    }
}
