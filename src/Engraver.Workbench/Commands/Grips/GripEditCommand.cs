using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Objects;

namespace Engraver.Workbench.Commands.Grips;

/// <summary>GRIPEDIT: Drags the selected objects by a grip: stretches them, or after Enter moves, turns, scales or mirrors them. The canvas begins it when
/// a grip is pressed.</summary>
internal sealed class GripEditCommand : ICommand
{
    private const string Name = "GRIPEDIT";
    private const double MinFactor = 1e-6;
    private const double MaxFactor = 1e6;
    private static readonly IReadOnlyList<string> s_modes = ["Stretch", "Move", "Rotate", "Scale", "Mirror"];

    public CommandInfo Info { get; } = new(Name, CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var (drawing, selected) = (context.Drawing, ObjectSelection.WithoutLocked(context, context.Document.Current.Selection));
        if (!ObjectGrips.Find(drawing, selected).Any()) throw new CommandException(CommandFailure.Usage, Wording.Get("GripEdit.NothingSelected", ObjectGrips.MaxObjects));
        var at = await context.ValueAsync(new PointPrompt(Wording.Get("GripEdit.SpecifyGrip")) { Purpose = PointPurpose.Object }).ConfigureAwait(false);
        var hot = ObjectGrips.At(drawing, selected, at, ObjectSelection.PickRadius(context));
        if (hot.Count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("GripEdit.NoGrip", context.Precision.FormatPoint(at)));
        await DragAsync(context, new GripDrag(context, selected, hot)).ConfigureAwait(false);
    }

    /// <summary>One edit; with Copy several. Enter switches the mode, or ends the command after copies were made.</summary>
    private static async Task DragAsync(CommandContext context, GripDrag drag)
    {
        for (var mode = 0; ;)
        {
            var (edit, option) = await AskAsync(context, drag, s_modes[mode]).ConfigureAwait(false);
            if (edit is { } wanted && drag.TryCommit(wanted) && !drag.IsCopying) return;
            switch (option)
            {
                case "eXit":
                case "" when drag.Count > 0:
                    return;
                case "":
                    mode = (mode + 1) % s_modes.Count;
                    context.WriteMessage(Wording.Get("GripEdit.Mode", s_modes[mode].ToUpperInvariant()));
                    break;
                case "Base":
                    drag.BasePoint = await context.ValueAsync(new PointPrompt(Wording.Get("Editing.SpecifyBasePoint"))).ConfigureAwait(false);
                    break;
                case "Copy":
                    drag.IsCopying = true;
                    break;
                case "Undo":
                    drag.Undo();
                    break;
            }
        }
    }

    /// <returns>The edit, or the chosen option, "" for Enter.</returns>
    private static async Task<(GripDrag.Edit? Edit, string? Option)> AskAsync(CommandContext context, GripDrag drag, string mode)
    {
        var (instruction, options) = (Wording.Get("GripEdit." + mode), Keyword.List("Base", "Copy", "Undo", "eXit"));
        if (mode is "Rotate" or "Scale")
        {
            var isTurn = mode == "Rotate";
            var amount = new AmountPrompt(instruction, way => isTurn ? way.Direction.Positive().Degrees : way.Length)
            {
                Min = isTurn ? -MaxFactor : MinFactor, Max = MaxFactor, From = drag.BasePoint, Options = options, EnterEnds = true, Ghost = place => drag.Ghost(drag.CreateEdit(mode, place)),
            };
            var answer = await context.AskAsync(amount).ConfigureAwait(false);
            return answer is Answer<Amount>.Value { Result: Amount.Number { Value: var number } } ? (drag.CreateEdit(mode, number), null) : (null, answer is Answer<Amount>.SelectedOption { Option: var chosen } ? chosen : "");
        }

        var prompt = new PointPrompt(instruction) { From = drag.BasePoint, Options = options, EnterEnds = true, Ghost = place => drag.Ghost(drag.CreateEdit(mode, place)) };
        return await context.AskAsync(prompt).ConfigureAwait(false) switch
        {
            Answer<Point2D>.Value { Result: var place } => (drag.CreateEdit(mode, place), null),
            Answer<Point2D>.SelectedOption { Option: var option } => (null, option),
            _ => (null, ""),
        };
    }
}
