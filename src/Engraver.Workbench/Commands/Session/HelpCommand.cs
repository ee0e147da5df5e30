using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Session;

/// <summary>HELP: Lists the commands, or describes one.</summary>
internal sealed class HelpCommand : ICommand
{
    public CommandInfo Info { get; } = new("HELP", CommandGroup.File) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var answer = await context.AskAsync(new TextPrompt(Wording.Get("Help.EnterCommandName")) { EnterEnds = true }).ConfigureAwait(false);
        if (answer is not Answer<string>.Value { Result: var name }) context.WriteResult(output => WriteAll(context, output));
        else if (context.Catalog.Find(CommandPrefix.WithoutPrefix(name)) is { } command) context.WriteResult(output => WriteOne(context, command.Info, output));
        else throw new CommandException(CommandFailure.Usage, Wording.Get("Help.UnknownCommand", name));
    }

    private static void WriteAll(CommandContext context, TextWriter output)
    {
        foreach (var group in context.Catalog.All.GroupBy(info => info.Group))
        {
            output.WriteLine(Wording.Get($"CommandGroup.{group.Key}"));
            foreach (var info in group) output.WriteLine(Wording.Get("Help.Row", info.Name, info.Summary));
        }
    }

    private static void WriteOne(CommandContext context, CommandInfo info, TextWriter output)
    {
        output.WriteLine(Wording.Get("Help.One", info.Name, info.Summary));
        var aliases = context.Aliases.Commands.Where(pair => pair.Value == info.Name).Select(pair => pair.Key).Order(StringComparer.Ordinal).ToList();
        if (aliases.Count > 0) output.WriteLine(Wording.Get("Help.Aliases", string.Join(", ", aliases)));
        if (info.IsTransparent) output.WriteLine(Wording.Get("Help.Transparent", info.Name));
    }
}
