using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands.View;

/// <summary>OSNAP: Selects the object snap modes, or switches object snap on or off.</summary>
internal sealed class OsnapCommand : ICommand
{
    public CommandInfo Info { get; } = new("OSNAP", CommandGroup.View) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var modes = SystemVariables.Find("OSMODE");
        var prompt = new TextPrompt(Wording.Get("Osnap.EnterModes")) { Options = Keyword.List("ON", "OFF"), Default = SnapNames.Text((int)modes.Read(context)) };
        var answer = await context.AskAsync(prompt).ConfigureAwait(false);
        if (answer is Answer<string>.Value { Result: var typed }) modes.Write(context, Bits(typed));
        var off = answer is Answer<string>.SelectedOption { Option: "OFF" };
        context.View.Change(view => view with { ObjectSnap = !off });
    }

    /// <exception cref="CommandException">A name is unknown.</exception>
    private static int Bits(string typed)
    {
        var bits = 0;
        foreach (var name in typed.Split([',', ' '], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries))
        {
            bits |= SnapNames.Find(name) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("Osnap.UnknownMode", name, SnapNames.Text(int.MaxValue)));
        }

        return bits;
    }
}
