using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>FILLET: Joins two objects by a tangent arc. CHAMFER: Joins two lines by a line that cuts their corner.</summary>
internal sealed class FilletCommand : ICommand
{
    private const double Largest = 1e9;

    private readonly bool _bevels;

    private FilletCommand(string name, bool bevels) => (Info, _bevels) = (new CommandInfo(name, CommandGroup.Drawing), bevels);

    public static IReadOnlyList<ICommand> All { get; } = [new FilletCommand("FILLET", bevels: false), new FilletCommand("CHAMFER", bevels: true)];

    public CommandInfo Info { get; }

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var (steps, isMultiple) = (new EditSteps(context), false);
        SayShape(context);
        while (true)
        {
            CornerSide? first = null;
            var prompt = FirstPrompt(isMultiple) with { Refusal = at => (first = CornerSide.Under(context, at)) is null ? Wording.Get("Reshape.NoObject") : null };
            switch (await context.AskAsync(prompt).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value:
                    if (await JoinedAsync(context, steps, first!.Value).ConfigureAwait(false) && !isMultiple) return;
                    break;
                case Answer<Point2D>.Chosen { Option: "Undo" }:
                    steps.Undo();
                    break;
                case Answer<Point2D>.Chosen { Option: "Multiple" }:
                    isMultiple = true;
                    break;
                case Answer<Point2D>.Chosen { Option: "Polyline" }:
                    if (await PolylineAsync(context, steps).ConfigureAwait(false) && !isMultiple) return;
                    break;
                case Answer<Point2D>.Chosen { Option: var option }:
                    await ChangeAsync(context, option).ConfigureAwait(false);
                    break;
                default:
                    return;
            }
        }
    }

    private PointPrompt FirstPrompt(bool isMultiple) => new(Wording.Get(_bevels ? "Chamfer.SelectFirst" : "Fillet.SelectFirst"))
    {
        Use = PointUse.Object,
        EnterEnds = isMultiple,
        Options = Keyword.List("Undo", "Polyline", _bevels ? "Distance" : "Radius", "Trim", "Multiple"),
    };

    /// <returns>True if both objects were joined.</returns>
    private async Task<bool> JoinedAsync(CommandContext context, EditSteps steps, CornerSide first)
    {
        var shape = ShapeOf(context);
        ObjectSelection.Unlocked(context, [first.Entity]);
        var drawing = context.Drawing;
        CornerSide? found = null;
        var prompt = new PickPrompt(Wording.Get(_bevels ? "Chamfer.SelectSecond" : "Fillet.SelectSecond"))
        {
            Refusal = pick => (found = CornerSide.Under(context, pick.At)) is null ? Wording.Get("Reshape.NoObject") : null,
            Ghost = place => CornerSide.Under(context, place) is { } other && Corner.Between(drawing, first, other, shape) is { } corner ? corner.Shown : [],
        };
        context.ShowPicked([first.Entity]);
        var pick = await context.ValueAsync(prompt).ConfigureAwait(false);
        context.ShowPicked(null);
        var second = found!.Value;
        ObjectSelection.Unlocked(context, [second.Entity]);
        var wanted = pick.IsShifted ? shape with { Radius = 0.0, First = 0.0, Second = 0.0 } : shape;
        if (Corner.Between(drawing, first, second, wanted) is not { } joined) return Told(context, Corner.WhyNot(drawing, first, second));
        steps.Take(() => joined.Take(context));
        return true;
    }

    private async Task<bool> PolylineAsync(CommandContext context, EditSteps steps)
    {
        int? found = null;
        var prompt = new PointPrompt(Wording.Get("Fillet.SelectPolyline"))
        {
            Use = PointUse.Object,
            Refusal = at => (found = ObjectSelection.At(context, at)) is not { } under || context.Drawing.Entities[under].Type is not (CurveType.LwPolyline or CurveType.Polyline) ? Wording.Get("Fillet.NoPolyline") : null,
        };
        await context.ValueAsync(prompt).ConfigureAwait(false);
        var entity = found!.Value;
        ObjectSelection.Unlocked(context, [entity]);
        var rounded = RoundedPolyline.Of(context.Drawing, entity, ShapeOf(context));
        context.Say(Wording.Get(_bevels ? "Chamfer.Corners" : "Fillet.Corners", rounded.Made, rounded.Left));
        if (rounded.Made > 0) steps.Take(() => rounded.Take(context));
        return rounded.Made > 0;
    }

    private static bool Told(CommandContext context, string why)
    {
        context.Say(Wording.Get(why), MessageKind.Warning);
        return false;
    }

    private static async Task ChangeAsync(CommandContext context, string option)
    {
        if (option == "Trim")
        {
            var mode = await context.ChoiceAsync(Wording.Get("Fillet.TrimMode"), Keyword.List("Trim", "No"), context.Remembered("TRIMMODE", "Trim")).ConfigureAwait(false);
            context.Remember("TRIMMODE", mode);
        }
        else if (option == "Radius")
        {
            await NumberAsync(context, "FILLETRAD", "Fillet.SpecifyRadius", context.Remembered("FILLETRAD", "0")).ConfigureAwait(false);
        }
        else
        {
            var first = await NumberAsync(context, "CHAMFERA", "Chamfer.SpecifyFirst", context.Remembered("CHAMFERA", "0")).ConfigureAwait(false);
            await NumberAsync(context, "CHAMFERB", "Chamfer.SpecifySecond", first).ConfigureAwait(false);
        }
    }

    /// <summary>Asks for a length, typed or given by two points, and remembers it.</summary>
    private static async Task<string> NumberAsync(CommandContext context, string name, string instruction, string standard)
    {
        var prompt = new AmountPrompt(Wording.Get(instruction), way => way.Length) { Least = 0.0, Most = Largest, Default = standard };
        while (true)
        {
            switch (await context.ValueAsync(prompt).ConfigureAwait(false))
            {
                case Amount.Number { Of: var value }:
                    var text = value.ToString("R", CultureInfo.InvariantCulture);
                    context.Remember(name, text);
                    return text;
                case Amount.Beginning { At: var place }:
                    prompt = prompt with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Default = null, From = place };
                    break;
            }
        }
    }

    private CornerShape ShapeOf(CommandContext context)
    {
        return new CornerShape(Read("FILLETRAD"), Read("CHAMFERA"), Read("CHAMFERB"), _bevels, context.Remembered("TRIMMODE", "Trim") == "Trim");

        double Read(string name) => double.Parse(context.Remembered(name, "0"), CultureInfo.InvariantCulture);
    }

    private void SayShape(CommandContext context)
    {
        var shape = ShapeOf(context);
        var mode = Wording.Get(shape.Trims ? "Fillet.ModeTrim" : "Fillet.ModeNoTrim");
        context.Say(_bevels ? Wording.Get("Chamfer.Current", mode, NumberPrompt.Show(shape.First), NumberPrompt.Show(shape.Second)) : Wording.Get("Fillet.Current", mode, NumberPrompt.Show(shape.Radius)));
    }
}
