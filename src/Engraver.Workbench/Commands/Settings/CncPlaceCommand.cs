using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>CNCPLACE: Scales, mirrors, rotates and moves the open drawing for the machine. It is shown as placed; its file does not change. The placement
/// ends with the drawing.</summary>
internal sealed class CncPlaceCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCPLACE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var present = context.Document.Current.Settings.Placement;
        var option = await context.ChoiceAsync(Wording.Get("CncPlace.EnterOption", PlacementText.Of(present)), Keyword.List("Scale", "Mirror", "Rotate", "MOve", "None"), "Scale").ConfigureAwait(false);
        var placement = option switch
        {
            "Scale" => present with { Scale = await NumberAsync(context, "CncPlace.EnterScale", SettingTable.Scale, present.Scale).ConfigureAwait(false) },
            "Mirror" => present with { Mirror = await AxisAsync(context, "CncPlace.EnterMirror", present.Mirror).ConfigureAwait(false) },
            "Rotate" => present with { Rotation = Angle.FromDegrees(await NumberAsync(context, "CncPlace.EnterRotation", SettingTable.Rotate, present.Rotation.Degrees).ConfigureAwait(false)) },
            "MOve" => present with { Move = await VectorAsync(context, "CncPlace.EnterMove", present.Move).ConfigureAwait(false) },
            _ => DrawingPlacement.None,
        };
        Commit(context, placement);
        context.WriteMessage(Wording.Get("CncPlace.Placed", PlacementText.Of(placement)), MessageKind.Result);
    }

    private static void Commit(CommandContext context, DrawingPlacement placement)
    {
        var state = context.Document.Current;
        if (placement == state.Settings.Placement) return;
        var placed = state.PlacedBy(placement) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("DrawingChange.OutOfRange"));
        context.Commit(placed);
        context.View.ZoomExtents(placed.Drawing!);
    }

    private static async Task<double> NumberAsync(CommandContext context, string prompt, Setting setting, double present) =>
        await context.ValueAsync(new NumberPrompt(Wording.Get(prompt)) { Default = NumberPrompt.Format(present), Min = setting.Min, Max = setting.Max }).ConfigureAwait(false);

    private static async Task<MirrorAxis> AxisAsync(CommandContext context, string prompt, MirrorAxis present) =>
        Enum.Parse<MirrorAxis>(await context.ChoiceAsync(Wording.Get(prompt), Keyword.List([.. Enum.GetNames<MirrorAxis>()]), present.ToString()).ConfigureAwait(false));

    private static async Task<Vector2D> VectorAsync(CommandContext context, string prompt, Vector2D present)
    {
        while (true)
        {
            var typed = await context.ValueAsync(new TextPrompt(Wording.Get(prompt)) { Default = PointSetting.Exact(Point2D.Origin + present) }).ConfigureAwait(false);
            if (SettingTable.Move.ReadOption(typed) is ParsedInput<Vector2D>.Value { Result: var vector }) return vector;
            context.WriteMessage(Wording.Get("PointSetting.NotAPoint", typed), MessageKind.Error);
        }
    }
}
