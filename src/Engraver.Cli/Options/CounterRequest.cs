using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Cli.Options;

/// <summary><c>--counter</c>: sets counters, or decides about a plate that was not finished.</summary>
/// <param name="Values">The next number by counter.</param>
internal sealed record CounterRequest(CounterChoice Choice, IReadOnlyDictionary<string, long> Values)
{
    private const string Again = "again";
    private const string Next = "next";

    public static CounterRequest None { get; } = new(CounterChoice.Ask, new Dictionary<string, long>());

    /// <summary>For a verb that starts plates or forecasts them.</summary>
    public static Option<CounterRequest> NewOption() => New("again|next|NAME=VALUE", allowsChoice: true);

    /// <summary>For a verb that only sets counters.</summary>
    public static Option<CounterRequest> NewSettingOption() => New("NAME=VALUE", allowsChoice: false);

    private static Option<CounterRequest> New(string form, bool allowsChoice) => new("--counter")
    {
        HelpName = form,
        Description = Wording.Get(allowsChoice ? "Series.Counter" : "Counters.Set"),
        AllowMultipleArgumentsPerToken = false,
        Arity = ArgumentArity.OneOrMore,
        CustomParser = result => Parse(result, allowsChoice),
    };

    private static CounterRequest Parse(ArgumentResult result, bool allowsChoice)
    {
        var (choice, values) = (CounterChoice.Ask, new Dictionary<string, long>(StringComparer.OrdinalIgnoreCase));
        foreach (var token in result.Tokens)
        {
            var equals = token.Value.IndexOf('=', StringComparison.Ordinal);
            if (equals < 0 && allowsChoice && choice == CounterChoice.Ask && token.Value is Again or Next) choice = token.Value == Again ? CounterChoice.Again : CounterChoice.Next;
            else if (equals > 0 && SerialFieldReader.IsCounterName(token.Value[..equals]) && long.TryParse(token.Value.AsSpan(equals + 1), NumberStyles.None, CultureInfo.InvariantCulture, out var value) && value <= SerialFieldReader.MaxNumber && values.TryAdd(token.Value[..equals], value)) continue;
            else result.AddError(Wording.Get(allowsChoice ? "Series.InvalidCounter" : "Counters.InvalidSet", token.Value, SerialFieldReader.MaxNumber));
        }

        return new CounterRequest(choice, values);
    }
}
