using System.CommandLine;
using Engraver.Core.Languages;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Cli.Options;

/// <summary><c>--values</c>: what the fields in texts stand for in a program that is posted or read back.</summary>
internal static class ValuesOption
{
    public static Option<string?> New() => new("--values") { HelpName = "FILE.json", Description = Wording.Get("Series.Values") };

    /// <exception cref="UsageException">The file cannot be read, or is not a record of values.</exception>
    public static PlateValues Read(string? file)
    {
        if (file is null) return PlateValues.None;
        try
        {
            return PlateValues.FromJson(File.ReadAllText(file));
        }
        catch (Exception unusable) when (unusable is IOException or UnauthorizedAccessException or FormatException)
        {
            throw new UsageException(Wording.Get("Series.InvalidValues", file, unusable is FormatException ? unusable.Message : SystemErrorText.FromException(unusable)), unusable);
        }
    }
}
