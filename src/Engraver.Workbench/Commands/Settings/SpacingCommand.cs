using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>GRID and SNAP: a spacing, or on, or off. Kept between sessions.</summary>
internal sealed class SpacingCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_modes = Keyword.List("ON", "OFF");

    private readonly string _switch;
    private readonly string _spacing;

    private SpacingCommand(string name, string onOff, string spacing)
    {
        Info = new CommandInfo(name, CommandGroup.View) { IsTransparent = true };
        (_switch, _spacing) = (onOff, spacing);
    }

    public static IReadOnlyList<ICommand> All { get; } =
    [
        new SpacingCommand("GRID", "GRIDMODE", "GRIDUNIT"),
        new SpacingCommand("SNAP", "SNAPMODE", "SNAPUNIT"),
    ];

    public CommandInfo Info { get; }

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var spacing = SystemVariables.Find(_spacing);
        var prompt = new NumberPrompt(Wording.Get("Spacing." + Info.Name)) { Options = s_modes, Default = NumberPrompt.Format(spacing.Read(context)), Min = 1e-6, Max = 1e6 };
        var answer = await context.AskAsync(prompt).ConfigureAwait(false);
        if (answer is Answer<double>.Value { Result: var value }) spacing.Write(context, value);
        SystemVariables.Find(_switch).Write(context, answer is Answer<double>.SelectedOption { Option: "OFF" } ? 0.0 : 1.0);
    }
}
