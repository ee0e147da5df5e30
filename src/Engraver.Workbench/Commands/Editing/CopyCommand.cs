using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>COPY: Copies objects to several points until Enter. All copies are one undo step.</summary>
internal sealed class CopyCommand : ICommand
{
    private const int MaxItems = 1000;

    public CommandInfo Info { get; } = new("COPY", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetAsync(context, takesTexts: true).ConfigureAwait(false);
        var (ghost, copies) = (new SelectionGhost(context.Drawing, selected), new CopyRun(context, selected));
        if (await DisplacementPrompts.BaseAsync(context).ConfigureAwait(false) is not { } from) copies.Add([await DisplacementPrompts.TypedAsync(context, ghost).ConfigureAwait(false)]);
        else await PlaceAsync(context, ghost, from, copies).ConfigureAwait(false);
    }

    private static async Task PlaceAsync(CommandContext context, SelectionGhost ghost, Point2D from, CopyRun copies)
    {
        while (true)
        {
            switch (await context.AskAsync(NextPrompt(ghost, from, copies.Count)).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var to }:
                    copies.Add([to - from]);
                    break;
                case Answer<Point2D>.SelectedOption { Option: "Array" }:
                    copies.Add(await ArrayAsync(context, ghost, from).ConfigureAwait(false));
                    break;
                case Answer<Point2D>.SelectedOption { Option: "Undo" }:
                    copies.Undo();
                    break;
                case Answer<Point2D>.EndOfList:
                    copies.Add([from - Point2D.Origin]);
                    return;
                default:
                    return;
            }
        }
    }

    /// <summary>Before the first copy Enter uses the base point as displacement; afterwards it ends the command.</summary>
    private static PointPrompt NextPrompt(SelectionGhost ghost, Point2D from, int made)
    {
        var prompt = new PointPrompt(Wording.Get(made == 0 ? "Common.SpecifySecondPointOrDisplacement" : "Copy.SpecifySecondPoint")) { From = from, Ghost = DisplacementPrompts.GhostFrom(ghost, from) };
        return made == 0 ? prompt with { Options = Keyword.List("Array"), EnterEnds = true } : prompt with { Options = Keyword.List("Array", "Exit", "Undo"), Default = "Exit" };
    }

    /// <summary>A row of copies, spaced by the vector from the base point to the second point.</summary>
    private static async Task<IReadOnlyList<Vector2D>> ArrayAsync(CommandContext context, SelectionGhost ghost, Point2D from)
    {
        var items = (int)await context.ValueAsync(new NumberPrompt(Wording.Get("Copy.EnterItems")) { Min = 2, Max = MaxItems, IsInteger = true }).ConfigureAwait(false);
        var to = await context.ValueAsync(new PointPrompt(Wording.Get("Copy.SpecifySecondPoint")) { From = from, Ghost = place => ghost.Mapped([.. Ways(place - from).Select(Transform2D.Move)]) }).ConfigureAwait(false);
        return [.. Ways(to - from)];

        IEnumerable<Vector2D> Ways(Vector2D way) => Enumerable.Range(1, items - 1).Select(item => way * item);
    }

    /// <summary>The copies made so far.</summary>
    private sealed class CopyRun(CommandContext context, IReadOnlyList<int> selected)
    {
        private readonly UndoGroup _steps = new(context);
        private readonly Drawing _before = context.Drawing;

        public int Count => _steps.Count;

        /// <exception cref="CommandException">A coordinate would leave the range of a drawing.</exception>
        public void Add(IReadOnlyList<Vector2D> ways)
        {
            var edited = DrawingChange.Copied(context, Shown(), [.. ways.Select(Transform2D.Move)], reports: Count == 0);
            _steps.Commit(context.Document.Current with { Drawing = edited, Selection = [], Previous = Shown() });
            context.HighlightPicked(Shown());
        }

        public void Undo()
        {
            if (!_steps.Undo()) context.WriteMessage(Wording.Get("Copy.NothingToUndo"));
            context.HighlightPicked(Shown());
        }

        /// <summary>The selected objects in the drawing with the copies made so far.</summary>
        private IReadOnlyList<int> Shown() => DocumentState.Following(selected, _before, context.Drawing);
    }
}
