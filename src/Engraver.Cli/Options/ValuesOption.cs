using System.CommandLine;
using Engraver.Core.Languages;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Cli.Options;

/// <summary><c>--values</c>: what the fields in texts stand for in a program that is posted or read back.</summary>
internal static class ValuesOption
{
    public static Option<string?> New() => new("--values") { HelpName = "FILE.json", Description = Wording.Get("Series.Values") };

    /// <exception cref="UsageException">The file cannot be read, or is not a record of values, or has none.</exception>
    public static PlateValues Read(string? file)
    {
        if (file is null) return PlateValues.None;
        try
        {
            var values = PlateValues.FromJson(File.ReadAllText(file));
            return values.IsNone ? throw new UsageException(Wording.Get("Series.NotValues", file)) : values;
        }
        catch (FormatException other)
        {
            throw new UsageException(Wording.Get("Series.NotValues", file), other);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            throw new UsageException(Wording.Get("Series.InvalidValues", file, SystemErrorText.FromException(unreadable)), unreadable);
        }
    }
}
