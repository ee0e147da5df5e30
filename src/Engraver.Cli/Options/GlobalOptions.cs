using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;

namespace Engraver.Cli.Options;

/// <summary>Options that every verb takes.</summary>
internal sealed class GlobalOptions
{
    private readonly Option<bool> _quiet = new("--quiet") { Description = "Only errors on standard error, no progress.", Recursive = true };
    private readonly Option<bool> _verbose = new("--verbose") { Description = "Also diagnostics of severity info.", Recursive = true };
    private readonly Option<CultureInfo?> _culture = new("--culture")
    {
        Description = "Language of the texts (a culture name); numbers always keep the point.",
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
            result.AddError($"'{name}' is not a culture name; use one like en-GB or de-DE.");
            return null;
        }
    }
}
