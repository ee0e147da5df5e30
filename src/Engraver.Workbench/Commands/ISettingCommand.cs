namespace Engraver.Workbench.Commands;

/// <summary>A command that asks for the new value of one setting, and can say the one it has.</summary>
internal interface ISettingCommand : ICommand
{
    string ValueText(CommandContext context);
}
