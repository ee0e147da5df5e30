using System.Globalization;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;

namespace Engraver.Workbench.Commands.View;

/// <summary>OSNAP: Chooses the places of objects that the crosshair jumps to, or switches that on or off.</summary>
internal sealed class OsnapCommand : ICommand
{
    /// <summary>Names and OSMODE bits as in AutoCAD.</summary>
    private static readonly IReadOnlyList<(string Name, int Bit)> s_modes = [("END", 1), ("MID", 2), ("CEN", 4), ("QUA", 16), ("INT", 32)];

    public CommandInfo Info { get; } = new("OSNAP", CommandGroup.View) { Transparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var modes = SystemVariables.Find("OSMODE");
        var prompt = new TextPrompt(Wording.Get("Osnap.EnterListObjectSnap")) { Options = Keyword.List("ON", "OFF"), Default = Text((int)modes.Read(context)) };
        var answer = await context.AskAsync(prompt).ConfigureAwait(false);
        if (answer is Answer<string>.Value { Of: var typed }) modes.Write(context, Bits(typed));
        var off = answer is Answer<string>.Chosen { Option: "OFF" };
        context.View.Change(view => view with { ObjectSnap = !off });
    }

    private static string Text(int bits) => bits == 0 ? "NONE" : string.Join(',', s_modes.Where(mode => (bits & mode.Bit) != 0).Select(mode => mode.Name));

    /// <exception cref="CommandException">One of them is unknown.</exception>
    private static int Bits(string typed)
    {
        if (typed.Equals("NONE", StringComparison.OrdinalIgnoreCase)) return 0;
        var bits = 0;
        foreach (var name in typed.Split([',', ' '], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries))
        {
            var mode = s_modes.FirstOrDefault(mode => name.StartsWith(mode.Name, true, CultureInfo.InvariantCulture));
            bits |= mode.Bit != 0 ? mode.Bit : throw new CommandException(CommandFailure.Usage, Wording.Get("Osnap.ThereNoObjectSnap", name, Text(int.MaxValue)));
        }

        return bits;
    }
}
