using Engraver.Core.Machines.Setup;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>Tests whether each axis moves and in which direction counts increase: the sign of its counts per millimetre.</summary>
internal sealed class DirectionStep : ICommissioningStep
{
    /// <summary>For X, Y and Z.</summary>
    private static readonly IReadOnlyList<Keyword>[] s_ways =
        [Keyword.List("Right", "Left", "Nothing", "Wild", "Keep"), Keyword.List("Back", "Front", "Nothing", "Wild", "Keep"), Keyword.List("Up", "Down", "Nothing", "Wild", "Keep")];

    public string Name => Wording.Get("Commission.DirectionStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        await machine.Moves.AskSpeedAsync().ConfigureAwait(false);
        var prompt = new NumberPrompt(Wording.Get("Commission.EnterDistance")) { Min = 1.0, Max = 1e6, IsInteger = true, Default = machine.Context.LastValue("CNCCOMMISSION", "1000") };
        var counts = (int)await machine.Context.ValueAsync(prompt).ConfigureAwait(false);
        machine.Context.Remember("CNCCOMMISSION", NumberPrompt.Format(counts));
        for (var i = 0; i < machine.Letters.Length; i++)
        {
            if (!await AxisAsync(machine, machine.Profile.Axes.All[i].Letter, s_ways[i], counts, cancellation).ConfigureAwait(false)) return false;
        }

        return true;
    }

    /// <returns>False if something has to be repaired first.</returns>
    private static async Task<bool> AxisAsync(CommissionedMachine machine, char letter, IReadOnlyList<Keyword> ways, int counts, CancellationToken cancellation)
    {
        if (!await machine.Moves.MoveAsync(letter, counts, cancellation).ConfigureAwait(false)) return false;
        switch (await machine.Context.ChoiceAsync(Wording.Get("Commission.EnterObservedDirection", letter), ways, "Keep").ConfigureAwait(false))
        {
            case "Wild":
                await machine.Moves.RanAwayAsync().ConfigureAwait(false);
                return false;
            case "Nothing":
                machine.Context.WriteMessage(Wording.Get("Commission.AxisDidNotMove", letter), MessageKind.Warning);
                return false;
            case "Right" or "Back" or "Up": Turn(machine, letter, isPlus: true); break;
            case "Left" or "Front" or "Down": Turn(machine, letter, isPlus: false); break;
            default: break;
        }

        await machine.Moves.MoveAsync(letter, -counts, cancellation).ConfigureAwait(false); // it may stay there: which way it goes is known
        return true;
    }

    private static void Turn(CommissionedMachine machine, char letter, bool isPlus)
    {
        var axis = ProfileAxis.Of(machine.Profile, letter);
        if (axis.Scale.IsMirrored == isPlus) machine.Profile = ProfileAxis.With(machine.Profile, LetterF.Mirrored(axis));
        machine.Context.WriteMessage(Wording.Get(isPlus ? "Commission.CountsPlus" : "Commission.CountsMinus", letter), MessageKind.Result);
    }
}
