using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>A drawing aid that is on or off: ORTHO, POLAR, DYNAMICINPUT. Kept between sessions.</summary>
internal sealed class SwitchCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_modes = Keyword.List("ON", "OFF");

    private readonly string _variable;
    private readonly string? _excluded;

    /// <param name="excluded">The variable of an aid that cannot be on together with this one; null for none.</param>
    private SwitchCommand(string name, string variable, string? excluded = null)
    {
        Info = new CommandInfo(name, CommandGroup.View) { IsTransparent = true };
        (_variable, _excluded) = (variable, excluded);
    }

    public static IReadOnlyList<ICommand> All { get; } =
    [
        new SwitchCommand("ORTHO", "ORTHOMODE", "POLARTRACK"),
        new SwitchCommand("POLAR", "POLARTRACK", "ORTHOMODE"),
        new SwitchCommand("DYNAMICINPUT", "DYNMODE"),
    ];

    public CommandInfo Info { get; }

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var variable = SystemVariables.Find(_variable);
        var now = variable.Read(context) != 0.0 ? "ON" : "OFF";
        var mode = await context.ChoiceAsync(Wording.Get("Common.EnterMode"), s_modes, now).ConfigureAwait(false);
        if (mode == "ON" && _excluded is not null) SystemVariables.Find(_excluded).Write(context, 0.0);
        variable.Write(context, mode == "ON" ? 1.0 : 0.0);
    }
}
