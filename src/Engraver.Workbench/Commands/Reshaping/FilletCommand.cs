using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>FILLET: Joins two objects by a tangent arc. CHAMFER: Joins two lines by a line that cuts their corner.</summary>
internal sealed class FilletCommand : ICommand
{
    private const double MaxSize = 1e9;

    private readonly bool _isChamfer;

    private FilletCommand(string name, bool bevels) => (Info, _isChamfer) = (new CommandInfo(name, CommandGroup.Drawing), bevels);

    public static IReadOnlyList<ICommand> All { get; } = [new FilletCommand("FILLET", bevels: false), new FilletCommand("CHAMFER", bevels: true)];

    public CommandInfo Info { get; }

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var (steps, isMultiple) = (new EditUndo(context), false);
        WriteSettings(context);
        while (true)
        {
            CornerSide? first = null;
            var prompt = FirstPrompt(isMultiple) with { Validate = at => (first = CornerSide.Under(context, at)) is null ? Wording.Get("Reshape.NoObject") : null };
            switch (await context.AskAsync(prompt).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value:
                    if (await JoinedAsync(context, steps, first!.Value).ConfigureAwait(false) && !isMultiple) return;
                    break;
                case Answer<Point2D>.SelectedOption { Option: "Undo" }:
                    steps.Undo();
                    break;
                case Answer<Point2D>.SelectedOption { Option: "Multiple" }:
                    isMultiple = true;
                    break;
                case Answer<Point2D>.SelectedOption { Option: "Polyline" }:
                    if (await PolylineAsync(context, steps).ConfigureAwait(false) && !isMultiple) return;
                    break;
                case Answer<Point2D>.SelectedOption { Option: var option }:
                    await ChangeAsync(context, option).ConfigureAwait(false);
                    break;
                default:
                    return;
            }
        }
    }

    private PointPrompt FirstPrompt(bool isMultiple) => new(Wording.Get(_isChamfer ? "Chamfer.SelectFirst" : "Fillet.SelectFirst"))
    {
        Purpose = PointPurpose.Object,
        EnterEnds = isMultiple,
        Options = Keyword.List("Undo", "Polyline", _isChamfer ? "Distance" : "Radius", "Trim", "Multiple"),
    };

    /// <returns>True if both objects were joined.</returns>
    private async Task<bool> JoinedAsync(CommandContext context, EditUndo steps, CornerSide first)
    {
        var shape = SettingsOf(context);
        ObjectSelection.Unlocked(context, [first.Entity]);
        var drawing = context.Drawing;
        CornerSide? found = null;
        var prompt = new PickPrompt(Wording.Get(_isChamfer ? "Chamfer.SelectSecond" : "Fillet.SelectSecond"))
        {
            Validate = pick => (found = CornerSide.Under(context, pick.At)) is null ? Wording.Get("Reshape.NoObject") : null,
            Ghost = place => CornerSide.Under(context, place) is { } other && CornerEdit.Between(drawing, first, other, shape) is { } corner ? corner.Preview : [],
        };
        context.HighlightPicked([first.Entity]);
        var pick = await context.ValueAsync(prompt).ConfigureAwait(false);
        context.HighlightPicked(null);
        var second = found!.Value;
        ObjectSelection.Unlocked(context, [second.Entity]);
        var wanted = pick.IsShifted ? shape with { Radius = 0.0, First = 0.0, Second = 0.0 } : shape;
        if (CornerEdit.Between(drawing, first, second, wanted) is not { } joined) return WriteRefusal(context, CornerEdit.RefusalOf(drawing, first, second));
        steps.Run(() => joined.Commit(context));
        return true;
    }

    private async Task<bool> PolylineAsync(CommandContext context, EditUndo steps)
    {
        int? found = null;
        var prompt = new PointPrompt(Wording.Get("Fillet.SelectPolyline"))
        {
            Purpose = PointPurpose.Object,
            Validate = at => (found = ObjectSelection.EntityAt(context, at)) is not { } under || context.Drawing.Entities[under].Type is not (CurveType.LwPolyline or CurveType.Polyline) ? Wording.Get("Fillet.NoPolyline") : null,
        };
        await context.ValueAsync(prompt).ConfigureAwait(false);
        var entity = found!.Value;
        ObjectSelection.Unlocked(context, [entity]);
        var rounded = RoundedPolyline.Of(context.Drawing, entity, SettingsOf(context));
        context.WriteMessage(Wording.Get(_isChamfer ? "Chamfer.Corners" : "Fillet.Corners", rounded.Rounded, rounded.Skipped));
        if (rounded.Rounded > 0) steps.Run(() => rounded.Commit(context));
        return rounded.Rounded > 0;
    }

    private static bool WriteRefusal(CommandContext context, string why)
    {
        context.WriteMessage(Wording.Get(why), MessageKind.Warning);
        return false;
    }

    private static async Task ChangeAsync(CommandContext context, string option)
    {
        if (option == "Trim")
        {
            var mode = await context.ChoiceAsync(Wording.Get("Fillet.TrimMode"), Keyword.List("Trim", "No"), context.LastValue("TRIMMODE", "Trim")).ConfigureAwait(false);
            context.Remember("TRIMMODE", mode);
        }
        else if (option == "Radius")
        {
            await NumberAsync(context, "FILLETRAD", "Fillet.SpecifyRadius", context.LastValue("FILLETRAD", "0")).ConfigureAwait(false);
        }
        else
        {
            var first = await NumberAsync(context, "CHAMFERA", "Chamfer.SpecifyFirst", context.LastValue("CHAMFERA", "0")).ConfigureAwait(false);
            await NumberAsync(context, "CHAMFERB", "Chamfer.SpecifySecond", first).ConfigureAwait(false);
        }
    }

    /// <summary>Asks for a length, typed or given by two points, and remembers it.</summary>
    private static async Task<string> NumberAsync(CommandContext context, string name, string instruction, string standard)
    {
        var prompt = new AmountPrompt(Wording.Get(instruction), way => way.Length) { Min = 0.0, Max = MaxSize, Default = standard };
        while (true)
        {
            switch (await context.ValueAsync(prompt).ConfigureAwait(false))
            {
                case Amount.Number { Value: var value }:
                    var text = value.ToString("R", CultureInfo.InvariantCulture);
                    context.Remember(name, text);
                    return text;
                case Amount.FirstPoint { Point: var place }:
                    prompt = prompt with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Default = null, From = place };
                    break;
            }
        }
    }

    private FilletSettings SettingsOf(CommandContext context)
    {
        return new FilletSettings(Read("FILLETRAD"), Read("CHAMFERA"), Read("CHAMFERB"), _isChamfer, context.LastValue("TRIMMODE", "Trim") == "Trim");

        double Read(string name) => double.Parse(context.LastValue(name, "0"), CultureInfo.InvariantCulture);
    }

    private void WriteSettings(CommandContext context)
    {
        var shape = SettingsOf(context);
        var mode = Wording.Get(shape.TrimsSides ? "Fillet.ModeTrim" : "Fillet.ModeNoTrim");
        context.WriteMessage(_isChamfer ? Wording.Get("Chamfer.Current", mode, NumberPrompt.Format(shape.First), NumberPrompt.Format(shape.Second)) : Wording.Get("Fillet.Current", mode, NumberPrompt.Format(shape.Radius)));
    }
}
