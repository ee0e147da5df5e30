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
        var option = await context.ChoiceAsync(Wording.Get("CncPlace.EnterOption", PlacementText.Of(present)), Keyword.List("Scale", "Mirror", "Rotate", "Place", "ALign", "MOve", "Blank", "bacK", "None"), "Scale").ConfigureAwait(false);
        var placement = option switch
        {
            "Scale" => present with { Scale = await TypedAsync(context, "CncPlace.EnterScale", SettingTable.Scale).ConfigureAwait(false) },
            "Mirror" => present with { Mirror = await AxisAsync(context, "CncPlace.EnterMirror", present.Mirror).ConfigureAwait(false) },
            "Rotate" => present with { Rotation = Angle.FromDegrees(await NumberAsync(context, "CncPlace.EnterRotation", SettingTable.Rotate, present.Rotation.Degrees).ConfigureAwait(false)) },
            "MOve" => present with { Move = await TypedAsync(context, "CncPlace.EnterMove", SettingTable.Move).ConfigureAwait(false) },
            "Place" => present with { Place = await PlaceAsync(context, present.Place).ConfigureAwait(false) },
            "ALign" => await AlignedAsync(new AlignmentPoints(context, present), present, cancellation).ConfigureAwait(false),
            "Blank" => present with { Blank = await TypedAsync(context, "CncPlace.EnterBlank", SettingTable.Blank).ConfigureAwait(false) },
            "bacK" => present with { Back = await AxisAsync(context, "CncPlace.EnterBack", present.Back).ConfigureAwait(false) },
            _ => DrawingPlacement.None,
        };
        Commit(context, placement);
        context.WriteMessage(Wording.Get("CncPlace.Placed", PlacementText.Of(placement)), MessageKind.Result);
    }

    private static void Commit(CommandContext context, DrawingPlacement placement)
    {
        var state = context.Document.Current;
        if (placement == state.Settings.Placement) return;
        if (SettingTable.Blank.Conflict(state.Settings with { Placement = placement }) is { } conflict) throw new CommandException(CommandFailure.Usage, SettingWording.AtCommandLine(conflict));
        var (placed, refusal) = state.PlacedBy(placement);
        if (placed is null) throw new CommandException(CommandFailure.Usage, SettingWording.AtCommandLine(refusal!).Message);
        context.Commit(placed);
        context.View.ZoomExtents(placed.Drawing!);
    }

    private static async Task<double> NumberAsync(CommandContext context, string prompt, Setting setting, double present) =>
        await context.ValueAsync(new NumberPrompt(Wording.Get(prompt)) { Default = NumberPrompt.Format(present), Min = setting.Min, Max = setting.Max }).ConfigureAwait(false);

    private static async Task<MirrorAxis> AxisAsync(CommandContext context, string prompt, MirrorAxis present) =>
        Enum.Parse<MirrorAxis>(await context.ChoiceAsync(Wording.Get(prompt), Keyword.List([.. Enum.GetNames<MirrorAxis>()]), present.ToString()).ConfigureAwait(false));

    private static async Task<BlankPlace> PlaceAsync(CommandContext context, BlankPlace present) =>
        Enum.Parse<BlankPlace>(await context.ChoiceAsync(Wording.Get("CncPlace.EnterPlace"), Keyword.List("None", "COrner", "CEntre"), present switch { BlankPlace.Corner => "COrner", BlankPlace.Centre => "CEntre", _ => "None" }).ConfigureAwait(false), ignoreCase: true);

    private static async Task<DrawingPlacement> AlignedAsync(AlignmentPoints points, DrawingPlacement present, CancellationToken cancellation) => present with
    {
        Place = BlankPlace.None,
        Align = await points.OfDrawingAsync(cancellation).ConfigureAwait(false),
        To = await points.OfMachineAsync(cancellation).ConfigureAwait(false),
    };

    /// <summary>Asks until the text is a value of the setting's option.</summary>
    private static async Task<T> TypedAsync<T>(CommandContext context, string prompt, Setting<T> setting)
    {
        var present = setting.ToWord(context.Document.Current.Settings) ?? setting.Default;
        var shown = setting.WhyNotOption(present) is null ? present : null; // "none" is not a value
        while (true)
        {
            var typed = await context.ValueAsync(new TextPrompt(Wording.Get(prompt)) { Default = shown }).ConfigureAwait(false);
            if (setting.ReadOption(typed) is ParsedInput<T>.Value { Result: var value }) return value;
            context.WriteMessage(setting.WhyNotOption(typed)!, MessageKind.Error);
        }
    }
}
