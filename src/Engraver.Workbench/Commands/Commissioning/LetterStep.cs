using Engraver.Core.Geometry;
using Engraver.Core.Machines.Setup;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>Detects mirrored and swapped axes from a drawn letter F.</summary>
internal sealed class LetterStep : ICommissioningStep
{
    /// <summary>Limits of counts per millimetre: at 10 mm the letter would have too few counts, or too many for a path.</summary>
    private const double Coarsest = 1.0;
    private const double Finest = 100_000.0;

    private static readonly IReadOnlyList<Keyword> s_ways = Keyword.List("Right", "Left", "Back", "Front", "Keep");

    public string Name => Wording.Get("Commission.LetterStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        await machine.Moves.AskSpeedAsync().ConfigureAwait(false);
        if (!await machine.SwitchAllOnAsync(cancellation).ConfigureAwait(false)) return false;
        var drawn = machine.Profile.Axes;
        if (drawn.Scale.Coarser.CountsOf(1.0) < Coarsest || drawn.Scale.Finer.CountsOf(1.0) > Finest)
        {
            machine.Context.WriteMessage(Wording.Get("Commission.ScaleOutOfRangeForF", Coarsest, Finest), MessageKind.Warning);
            return false;
        }

        var farthest = drawn.Scale.ToCounts(new Point2D(LetterF.Width, LetterF.Height));
        if (!await machine.Context.ConfirmAsync(Wording.Get("Commission.ConfirmDrawF", drawn.X.Letter, farthest.X, drawn.Y.Letter, farthest.Y, machine.Moves.Speed)).ConfigureAwait(false))
        {
            machine.Context.WriteMessage(Wording.Get("Commission.NotMoved"));
            return false;
        }

        if (!await machine.Moves.DrawAsync(LetterF.Program(machine.Moves.TestPlane, drawn, machine.Moves.Speed), cancellation).ConfigureAwait(false)) return false;
        if (await AskAsync(machine, "Commission.LongStrokeDirection").ConfigureAwait(false) is not { } longStroke || await AskAsync(machine, "Commission.BarsDirection").ConfigureAwait(false) is not { } bars) return true;
        if (LetterF.Corrected(drawn, longStroke, bars) is not { } axes)
        {
            machine.Context.WriteMessage(Wording.Get("Commission.ImpossibleLetter"), MessageKind.Warning);
            return false;
        }

        machine.Context.WriteMessage(Wording.Get(axes == drawn ? "Commission.LetterCorrect" : axes.X.Letter == drawn.X.Letter ? "Commission.LetterMirrored" : "Commission.LetterSwapped"), MessageKind.Result);
        machine.Profile = machine.Profile with { Axes = axes };
        return true;
    }

    /// <returns>Null: unchanged.</returns>
    private static async Task<TableDirection?> AskAsync(CommissionedMachine machine, string question) =>
        await machine.Context.ChoiceAsync(Wording.Get(question), s_ways, "Keep").ConfigureAwait(false) is var answer && answer != "Keep" ? Enum.Parse<TableDirection>(answer) : null;
}
