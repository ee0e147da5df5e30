using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>OPTIONS: Shows every setting with its value and meaning, in a window where there is one; else, and as -OPTIONS, it lists them, and a name
/// changes one.</summary>
internal sealed class OptionsCommand : ICommand
{
    public CommandInfo Info { get; } = new("OPTIONS", CommandGroup.File) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.TryOpenDialog()) return;
        context.WriteResult(output => Write(context, output));
        var prompt = new TextPrompt(Wording.Get("Options.EnterName")) { EnterEnds = true };
        if (await context.AskAsync(prompt).ConfigureAwait(false) is not Answer<string>.Value { Result: var name }) return;
        if (context.Catalog.Find(name) is not { Info.Group: CommandGroup.Setting } setting) throw new CommandException(CommandFailure.Usage, Wording.Get("Options.UnknownSetting", name));
        if (context.OuterCommand is { } outer && !setting.Info.IsTransparent) throw new CommandException(CommandFailure.Usage, Wording.Get("CommandSession.CannotRunInside", setting.Info.Name, outer)); // its undo step would be between those of the other command
        await setting.RunAsync(context, cancellation).ConfigureAwait(false);
    }

    private static void Write(CommandContext context, TextWriter output)
    {
        foreach (var info in context.Catalog.All.Where(info => info.Group == CommandGroup.Setting))
        {
            var value = context.Catalog.Find(info.Name) is ISettingCommand setting ? setting.ValueText(context) : "";
            output.WriteLine(Wording.Get("Options.Row", info.Name, value, info.Summary));
        }
    }
}
