using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>A setting that is typed by its name and asks for a new value, like AutoCAD's system variables. Enter keeps the present value.</summary>
internal sealed class SettingCommand(Setting setting) : ISettingCommand
{
    /// <summary>One for each setting whose command is not a class of its own.</summary>
    public static IEnumerable<ICommand> All => SettingTable.All.Where(setting => !setting.HasOwnCommand).Select(setting => new SettingCommand(setting));

    public CommandInfo Info { get; } = new(setting.Command, CommandGroup.Setting);

    public string ValueText(CommandContext context) => setting.ToInput(context.Document.Current.Settings);

    /// <exception cref="CommandException">The machine cannot work with that value.</exception>
    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var input = await InputAsync(context).ConfigureAwait(false);
        var state = context.Document.Current;
        try
        {
            context.Commit(state with { Settings = setting.FromInput(state.Settings, input) });
        }
        catch (SettingException unusable)
        {
            throw new CommandException(CommandFailure.Usage, unusable.Message);
        }
    }

    private async Task<string> InputAsync(CommandContext context)
    {
        if (setting.Choices.Count > 0) return await context.ChoiceAsync(setting.Instruction, Keyword.List([.. setting.Choices]), ValueText(context)).ConfigureAwait(false);
        var prompt = new NumberPrompt(setting.Instruction) { Default = ValueText(context), Min = setting.Min, Max = setting.Max, IsInteger = setting.Whole };
        return TypedNumber.Exact(await context.ValueAsync(prompt).ConfigureAwait(false));
    }
}
