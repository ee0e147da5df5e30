using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Engraver.Core.Languages;

namespace Engraver.Cli.Options;

/// <summary>Options that every verb takes.</summary>
internal sealed class GlobalOptions
{
    private const string QuietName = "--quiet";

    private readonly Option<bool> _quiet = new(QuietName) { Description = Wording.Get("GlobalOptions.Quiet"), Recursive = true };
    private readonly Option<bool> _verbose = new("--verbose") { Description = Wording.Get("GlobalOptions.Verbose"), Recursive = true };
    private readonly Option<CultureInfo?> _culture = new("--culture")
    {
        Description = Wording.Get("GlobalOptions.Culture"),
        HelpName = "NAME",
        Recursive = true,
        CustomParser = ParseCulture,
    };

    public void AddTo(RootCommand root)
    {
        root.Options.Add(_quiet);
        root.Options.Add(_verbose);
        root.Options.Add(_culture);
    }

    public bool Quiet(ParseResult parsed) => parsed.GetValue(_quiet);

    public bool Verbose(ParseResult parsed) => parsed.GetValue(_verbose);

    /// <summary>The same for a caller that has only the parsed line.</summary>
    public static bool IsErrorsOnly(ParseResult parsed) => parsed.RootCommandResult.Command.Options.OfType<Option<bool>>().Any(option => option.Name == QuietName && parsed.GetValue(option));

    /// <summary>The language that the arguments ask for. Help and refusals use it too, so it is searched for before anything is parsed; null when
    /// there is none, or none that is known.</summary>
    public static CultureInfo? Language(string[] args)
    {
        const string Name = "--culture";
        var at = Array.FindLastIndex(args, word => word == Name || word.StartsWith(Name + "=", StringComparison.Ordinal) || word.StartsWith(Name + ":", StringComparison.Ordinal));
        if (at < 0 || (args[at] == Name && at + 1 == args.Length)) return null;
        return Find(args[at] == Name ? args[at + 1] : args[at][(Name.Length + 1)..]);
    }

    private static CultureInfo? ParseCulture(ArgumentResult result)
    {
        var name = result.Tokens[0].Value;
        var culture = Find(name);
        if (culture is null) result.AddError(Wording.Get("GlobalOptions.InvalidCulture", name));
        return culture;
    }

    private static CultureInfo? Find(string name)
    {
        try
        {
            return CultureInfo.GetCultureInfo(name, predefinedOnly: !name.Equals(PseudoLanguage.CultureName, StringComparison.OrdinalIgnoreCase));
        }
        catch (CultureNotFoundException)
        {
            return null;
        }
    }
}
