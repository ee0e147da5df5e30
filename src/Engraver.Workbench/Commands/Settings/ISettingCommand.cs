namespace Engraver.Workbench.Commands.Settings;

/// <summary>A command that asks for the new value of one setting and can show the present one.</summary>
internal interface ISettingCommand : ICommand
{
    string ValueText(CommandContext context);
}
