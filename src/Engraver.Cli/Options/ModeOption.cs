using System.CommandLine;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary><c>--mode</c>: the execution strategy of a job, by the name that the driver gives it.</summary>
internal static class ModeOption
{
    private const string Name = "--mode";

    public static Option<string> New()
    {
        var strategies = MachineFamilies.Standard.All.SelectMany(family => family.Driver.Strategies, (family, strategy) => (family.Driver, Strategy: strategy)).DistinctBy(one => one.Strategy.Key).ToList();
        var option = new Option<string>(Name)
        {
            Description = string.Join("; ", strategies.Select(one => Wording.Get("ModeOption.Strategy", one.Strategy.Key, one.Driver.Describe(one.Strategy)))) + ".",
            DefaultValueFactory = _ => MachineFamilies.Default.DefaultStrategy.Key,
        };
        option.AcceptOnlyFromAmong([.. strategies.Select(one => one.Strategy.Key)]);
        return option;
    }

    /// <summary>The strategy for the machine of the settings: its driver's default unless the option is given.</summary>
    /// <exception cref="UsageException">The driver has no such strategy.</exception>
    public static ExecutionStrategy Strategy(ParseResult parsed, Option<string> option, DrawingSettings settings)
    {
        var driver = MachineFamilies.DriverOf(settings.Machine);
        if (parsed.GetResult(option) is not { Implicit: false }) return driver.DefaultStrategy;
        var key = parsed.GetValue(option);
        return driver.Strategies.FirstOrDefault(strategy => strategy.Key == key) ?? throw new UsageException(Wording.Get("ModeOption.NotOfFamily", driver.Name, key, string.Join(", ", driver.Strategies.Select(strategy => strategy.Key))));
    }
}
