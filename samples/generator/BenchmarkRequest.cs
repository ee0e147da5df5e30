using System.Globalization;
using Engraver.Samples.Dxf;

namespace Engraver.Samples;

/// <summary>What the command line asks of a benchmark drawing.</summary>
internal sealed record BenchmarkRequest(int Lines, string File, int Digits, bool Shuffled)
{
    private const int UsualDigits = 6;
    private const ulong Seed = 1;

    /// <summary>Reads <c>--lines N FILE [--digits D] [--shuffle]</c>; null where the arguments are anything else.</summary>
    public static BenchmarkRequest? From(ReadOnlySpan<string> arguments)
    {
        if (arguments is not ["--lines", var count, var file, .. var options] || !TryNumber(count, 1, int.MaxValue, out var lines))
        {
            return null;
        }

        var request = new BenchmarkRequest(lines, file, UsualDigits, Shuffled: false);
        while (options is not [])
        {
            switch (options)
            {
                case ["--shuffle", .. var rest]:
                    request = request with { Shuffled = true };
                    options = rest;
                    break;
                case ["--digits", var text, .. var rest] when TryNumber(text, 1, 17, out var digits) && digits != 16:
                    request = request with { Digits = digits };
                    options = rest;
                    break;
                default:
                    return null;
            }
        }

        return request;
    }

    public void Write()
    {
        using var stream = System.IO.File.Create(File);
        using var sink = new AsciiTagSink(stream, RealFormat.OfDigits(Digits));
        DxfWriter.Write(BenchmarkDrawing.Draw(Lines, Shuffled, Seed), sink);
    }

    private static bool TryNumber(string text, int least, int most, out int number) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number) && number >= least && number <= most;
}
