using Engraver.Core.Kerf;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>KERF: Sets the side of the lines on which the tool runs and its diameter.</summary>
internal sealed class KerfCommand : ICommand
{
    public CommandInfo Info { get; } = new("KERF", CommandGroup.Setting);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var settings = context.Document.Current.Settings;
        var side = Enum.Parse<KerfSide>(await context.ChoiceAsync(Wording.Get("Kerf.EnterSide"), Keyword.List("OFF", "Nesting", "Outside", "Inside", "Left", "Right"), settings.Kerf == KerfSide.Off ? "OFF" : settings.Kerf.ToString()).ConfigureAwait(false), ignoreCase: true);
        var diameter = side == KerfSide.Off ? settings.ToolDiameterMm : await DiameterAsync(context, settings.ToolDiameterMm).ConfigureAwait(false);
        var state = context.Document.Current;
        context.Take(state with { Settings = state.Settings with { Kerf = side, ToolDiameterMm = diameter } });
    }

    private static async Task<double> DiameterAsync(CommandContext context, double before)
    {
        var setting = SettingTable.ToolDiameter;
        return await context.ValueAsync(new NumberPrompt(Wording.Get("Kerf.SpecifyDiameter")) { Default = before > 0.0 ? NumberPrompt.Show(before) : null, Least = setting.Least, Most = setting.Most }).ConfigureAwait(false);
    }
}
