using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>A drawing aid that is on or off: ORTHO, DYNAMICINPUT. Kept between sessions.</summary>
internal sealed class SwitchCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_modes = Keyword.List("ON", "OFF");

    private readonly string _variable;

    private SwitchCommand(string name, string variable, string summary)
    {
        Info = new CommandInfo(name, CommandGroup.View, summary) { Transparent = true };
        _variable = variable;
    }

    public static IReadOnlyList<ICommand> All { get; } =
    [
        new SwitchCommand("ORTHO", "ORTHOMODE", "Points go straight across or straight up from the last one: on or off."),
        new SwitchCommand("DYNAMICINPUT", "DYNMODE", "What is asked and where the crosshair stands, shown beside it: on or off."),
    ];

    public CommandInfo Info { get; }

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var variable = SystemVariables.Find(_variable);
        var now = variable.Read(context) != 0.0 ? "ON" : "OFF";
        var mode = await context.ChoiceAsync("Enter mode", s_modes, now).ConfigureAwait(false);
        variable.Write(context, mode == "ON" ? 1.0 : 0.0);
    }
}
