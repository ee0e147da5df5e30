using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Core.Machines;

namespace Engraver.Cli.Options;

/// <summary><c>--rate</c>: what the machine costs.</summary>
internal static class RateOption
{
    public static Option<JobRates?> New() => new("--rate") { HelpName = "HOUR[,METRE[,START]]", Description = Wording.Get("Plan.Rate"), CustomParser = Parse };

    private static JobRates? Parse(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (JobRates.Parse(word) is { } rates) return rates;
        result.AddError(Wording.Get("Plan.InvalidRates", word));
        return null;
    }
}
