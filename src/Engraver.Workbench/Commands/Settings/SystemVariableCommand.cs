using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>A system variable typed by its name: asks for a new value, with the present one as default.</summary>
internal sealed class SystemVariableCommand : ISettingCommand
{
    private readonly SystemVariable _variable;

    private SystemVariableCommand(SystemVariable variable)
    {
        _variable = variable;
        Info = new CommandInfo(variable.Name, CommandGroup.Setting) { IsTransparent = true };
    }

    /// <summary>One for each variable that is not a command of another kind.</summary>
    public static IEnumerable<ICommand> All => SystemVariables.All.Select(variable => new SystemVariableCommand(variable));

    public CommandInfo Info { get; }

    public string ValueText(CommandContext context) => NumberPrompt.Format(_variable.Read(context));

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var prompt = new NumberPrompt(Wording.Get("Settings.EnterNewValue", _variable.Name))
        {
            Default = ValueText(context), Min = _variable.Min, Max = _variable.Max, IsInteger = _variable.IsInteger,
        };
        _variable.Write(context, await context.ValueAsync(prompt).ConfigureAwait(false));
    }
}
