using Engraver.Core.Drawings;
using Engraver.Core.Kerf;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>KERF: Sets the side of the lines on which the tool runs and its diameter; the path is seen before Enter takes it.</summary>
internal sealed class KerfCommand : ICommand
{
    public CommandInfo Info { get; } = new("KERF", CommandGroup.Setting);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var settings = context.Document.Current.Settings;
        var side = SettingTable.Kerf.ParseInput(await context.ChoiceAsync(Wording.Get("Kerf.EnterSide"), Keyword.List([.. SettingTable.Kerf.Choices]), SettingTable.Kerf.ToInput(settings)).ConfigureAwait(false));
        var diameter = side == KerfSide.Off ? settings.ToolDiameterMm : await DiameterAsync(context, side, settings.ToolDiameterMm).ConfigureAwait(false);
        var state = context.Document.Current;
        var changed = state.Settings with { Kerf = side, ToolDiameterMm = diameter };
        if (SettingTable.Operations.Conflict(changed) is { } conflict) throw new CommandException(CommandFailure.Usage, SettingWording.AtCommandLine(conflict));
        context.Commit(state with { Settings = changed });
        if (side != KerfSide.Off) OperationHint.Write(context, "Kerf.OperationsAreTheWay");
    }

    private static async Task<double> DiameterAsync(CommandContext context, KerfSide side, double before)
    {
        var (setting, shown) = (SettingTable.ToolDiameter, before);
        while (true)
        {
            var prompt = new NumberPrompt(Wording.Get("Kerf.SpecifyDiameter")) { Default = shown > 0.0 ? NumberPrompt.Format(shown) : null, Min = setting.Min, Max = setting.Max };
            if (context.Document.Current.Drawing is not { } drawing) return await context.ValueAsync(prompt).ConfigureAwait(false);
            var answer = await context.AskAsync(prompt with { Options = Keyword.List("Preview"), Preview = shown > 0.0 ? PathOf(drawing, context.Document.Current.Settings with { Kerf = side, ToolDiameterMm = shown }, context.PlateValues) : null }).ConfigureAwait(false);
            if (answer is Answer<double>.Value { Result: var diameter }) return diameter;
            shown = await context.ValueAsync(prompt with { Instruction = Wording.Get("Kerf.PreviewDiameter") }).ConfigureAwait(false);
        }
    }

    /// <summary>The path of the tool's centre, drawing units.</summary>
    private static GhostFunction PathOf(Drawing drawing, DrawingSettings settings, PlateValues values) =>
        _ => [.. JobPreparation.To<CompensatedJob>(drawing, settings, values).Cut.Table.ToSegments().Select(drawing.Scale.ToDrawing)];
}
