using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;

namespace Engraver.Cli.Options;

/// <summary>Options that every verb takes.</summary>
internal sealed class GlobalOptions
{
    private readonly Option<bool> _quiet = new("--quiet") { Description = Wording.Get("GlobalOptions.OnlyErrorsOnStandard"), Recursive = true };
    private readonly Option<bool> _verbose = new("--verbose") { Description = Wording.Get("GlobalOptions.AlsoDiagnosticsSeverityInfo"), Recursive = true };
    private readonly Option<CultureInfo?> _culture = new("--culture")
    {
        Description = Wording.Get("GlobalOptions.LanguageTextsCultureName"),
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

    public CultureInfo? Culture(ParseResult parsed) => parsed.GetValue(_culture);

    private static CultureInfo? ParseCulture(ArgumentResult result)
    {
        var name = result.Tokens[0].Value;
        try
        {
            return CultureInfo.GetCultureInfo(name, predefinedOnly: true);
        }
        catch (CultureNotFoundException)
        {
            result.AddError(Wording.Get("GlobalOptions.NotCultureNameUse", name));
            return null;
        }
    }
}
