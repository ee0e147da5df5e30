using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>A drawing aid that is on or off: ORTHO, DYNAMICINPUT. Kept between sessions.</summary>
internal sealed class SwitchCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_modes = Keyword.List("ON", "OFF");

    private readonly string _variable;

    private SwitchCommand(string name, string variable)
    {
        Info = new CommandInfo(name, CommandGroup.View) { Transparent = true };
        _variable = variable;
    }

    public static IReadOnlyList<ICommand> All { get; } =
    [
        new SwitchCommand("ORTHO", "ORTHOMODE"),
        new SwitchCommand("DYNAMICINPUT", "DYNMODE"),
    ];

    public CommandInfo Info { get; }

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var variable = SystemVariables.Find(_variable);
        var now = variable.Read(context) != 0.0 ? "ON" : "OFF";
        var mode = await context.ChoiceAsync(Wording.Get("Common.EnterMode"), s_modes, now).ConfigureAwait(false);
        variable.Write(context, mode == "ON" ? 1.0 : 0.0);
    }
}
