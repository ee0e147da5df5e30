using System.Globalization;
using Engraver.App.Texts;

namespace Engraver.App.Sessions;

/// <summary>The options of the command line (<c>engraver desktop</c>; see docs/cli-contract.md).</summary>
public sealed record DesktopOptions
{
    private const double MinScale = 0.5;
    private const double MaxScale = 4.0;

    /// <summary>The drawing to open; null for none.</summary>
    public string? File { get; init; }

    /// <summary>Path of a script to run once the window is open.</summary>
    public string? Script { get; init; }

    /// <summary>True: no display is needed; the program ends after the screenshot.</summary>
    public bool Headless { get; init; }

    /// <summary>Path of a picture of the window, written after file and script; null for none.</summary>
    public string? Screenshot { get; init; }

    /// <summary>Size of the window in units of 1/96 inch; null: the last size.</summary>
    public (int Width, int Height)? Size { get; init; }

    /// <summary>Pixels per unit; null: the scale of the display.</summary>
    public double? Scale { get; init; }

    /// <summary>Name of the culture that selects the language; null: that of LANGUAGE, otherwise that of the system.</summary>
    public string? Culture { get; init; }

    /// <summary>The measurement to run instead of the desktop; null: none (<see cref="BenchmarkName"/>).</summary>
    public string? Benchmark { get; init; }

    /// <summary>Parses the words of the command line.</summary>
    /// <returns>The options, or the sentence of the error.</returns>
    public static (DesktopOptions? Options, string? Wrong) Parse(IReadOnlyList<string> words)
    {
        var options = new DesktopOptions();
        for (var at = 0; at < words.Count; at++)
        {
            var word = words[at];
            if (word == "--headless") options = options with { Headless = true };
            else if (!word.StartsWith("--", StringComparison.Ordinal))
            {
                if (options.File is not null) return (null, Text.Get("Options.OneDrawing", word));
                options = options with { File = word };
            }
            else
            {
                if (at + 1 == words.Count) return (null, Text.Get("Options.NoValue", word));
                if (options.With(word, words[++at]) is not { } next) return (null, Text.Get("Options.Unknown", word, words[at]));
                options = next;
            }
        }

        return (options, null);
    }

    private DesktopOptions? With(string name, string value) => name switch
    {
        "--culture" => this with { Culture = value },
        "--script" => this with { Script = value },
        "--screenshot" => this with { Screenshot = value },
        "--benchmark" => BenchmarkName.All.Contains(value) ? this with { Benchmark = value } : null,
        "--size" => SizeOf(value) is { } size ? this with { Size = size } : null,
        "--scale" => double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out var scale) && scale is >= MinScale and <= MaxScale ? this with { Scale = scale } : null,
        _ => null,
    };

    private static (int Width, int Height)? SizeOf(string text)
    {
        var parts = text.Split('x');
        return parts.Length == 2 && Side(parts[0]) is { } width && Side(parts[1]) is { } height ? (width, height) : null;
    }

    private static int? Side(string text) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var side) && side is >= 100 and <= 16384 ? side : null;
}
