using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCTERMINAL: Sends one line to the connected controller and shows the answer; dangerous commands require the prefix "confirm".</summary>
internal sealed class CncTerminalCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCTERMINAL", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        var line = await context.ValueAsync(new TextPrompt(Wording.Get("CncTerminal.EnterLine"))).ConfigureAwait(false);
        foreach (var answer in await context.Machine.Connection.Terminal.TypeAsync(line, cancellation).ConfigureAwait(false))
        {
            if (answer.Kind is TerminalAnswerKind.Refusal or TerminalAnswerKind.Withheld) throw new CommandException(CommandFailure.Refused, answer.Text);
            context.WriteMessage(answer.Text, MessageKind.Result);
        }
    }
}
