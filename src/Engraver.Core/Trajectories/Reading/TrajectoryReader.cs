using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Posts;

namespace Engraver.Core.Trajectories.Reading;

/// <summary>Reads trajectory files back and runs them as their controller does, based only on the documentation of the controller (sace-xps-agie.md 2); shares
/// no code with the post.</summary>
/// <remarks>Several files are one text: each follows a line <c>; trajectory X Y</c>, the machine position at its start. Without that line the request gives the
/// machine position. One row is in memory at a time, for a spline four.</remarks>
public sealed class TrajectoryReader(ControllerLanguage language) : IProgramReader
{
    /// <summary>The start of the line before a file.</summary>
    public const string Mark = "; trajectory ";

    /// <summary>Number of findings after which reading stops.</summary>
    private const int MaxFindings = 100;

    public bool ReportsHeights => false;

    public Task<IReadOnlyList<Diagnostic>> ReplayAsync(TextReader text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(request);
        var start = request.Machine.Scale.ToMillimetres(request.Start.X, request.Start.Y);
        return Task.FromResult<IReadOnlyList<Diagnostic>>(new TrajectoryReplay(language, new TrajectoryTracer(request), start).Run(new ProgramRows(text), cancellation));
    }

    /// <summary>Reads through a text. An error in a file is one finding: its remaining rows are skipped, and the next file is read.</summary>
    private sealed class TrajectoryReplay(ControllerLanguage language, TrajectoryTracer teller, Point2D start)
    {
        private readonly List<Diagnostic> _findings = [];
        private Point2D _start = start;
        private TrajectoryRun? _run;
        private bool _hasRows;
        private bool _isWrong;

        public List<Diagnostic> Run(ProgramRows lines, CancellationToken cancellation)
        {
            while (_findings.Count < MaxFindings && lines.Next() is { } row)
            {
                cancellation.ThrowIfCancellationRequested();
                if (row.StartsWith(Mark, StringComparison.Ordinal)) Begin(row, lines.Number);
                else if (row.Split(';')[0].Trim() is { Length: > 0 } words) Take(words, lines.Number);
            }

            Finish();
            if (!_hasRows && _findings.Count == 0) _findings.Add(VerificationRules.ProgramEmpty.At(default));
            return _findings;
        }

        private void Begin(string row, int line)
        {
            Finish();
            if (TrajectoryRun.Numbers(row[Mark.Length..].Replace(' ', ',')) is [var x, var y]) _start = new Point2D(x, y);
            else _findings.Add(TrajectoryRun.Unreadable(line, row));
        }

        private void Take(string words, int line)
        {
            _hasRows = true;
            _run ??= TrajectoryRun.Of(language, _start, teller);
            if (!_isWrong) Keep(_run.Take(words, line));
        }

        private void Finish()
        {
            if (_run is not null && !_isWrong) Keep(_run.End());
            (_run, _isWrong) = (null, false);
        }

        private void Keep(Diagnostic? finding)
        {
            if (finding is null) return;
            _findings.Add(finding);
            _isWrong = true;
        }
    }
}

/// <summary>One trajectory while its controller runs it, row by row.</summary>
internal abstract class TrajectoryRun(TrajectoryTracer teller)
{
    /// <summary>Limit of numbers: larger numbers are not valid for a machine, and calculations with them would exceed the range of a double.</summary>
    private const double TooLarge = 1e12;

    private int _line;

    protected TrajectoryTracer Tracer { get; } = teller;

    public static TrajectoryRun Of(ControllerLanguage language, Point2D start, TrajectoryTracer teller) => language switch
    {
        ControllerLanguage.AbsoluteSpline => new SplineRun(default, isRelative: false, teller),
        ControllerLanguage.RelativeSpline => new SplineRun(start, isRelative: true, teller),
        ControllerLanguage.LineArc => new LineArcRun(start, teller),
        _ => new PvtRun(start, teller),
    };

    /// <returns>The reason why the row cannot be run; null when it was run.</returns>
    public Diagnostic? Take(string words, int line)
    {
        _line = line;
        return Run(words);
    }

    /// <summary>Called after the last row.</summary>
    public abstract Diagnostic? End();

    protected abstract Diagnostic? Run(string words);

    protected Diagnostic Unreadable(string words) => Unreadable(_line, words);

    /// <summary>Reports that the last row differs from the requirements of the job.</summary>
    protected void Differ(string said, string expected, int? line = null) => Tracer.Request.Requirements?.AddDifference(line ?? _line, said, expected);

    /// <summary>Number of the last row, from 1.</summary>
    protected int Line => _line;

    /// <summary>A finding at the last row.</summary>
    protected Diagnostic Wrong(string reason) => Wrong(_line, reason);

    public static Diagnostic Unreadable(int line, string words) => Wrong(line, Wording.Get("Xps.LineContent", words.Trim() is { Length: > 40 } all ? all[..40] : words.Trim()));

    /// <summary>Numbers separated by commas; null for any other text, and for numbers beyond the limit.</summary>
    public static double[]? Numbers(string words)
    {
        var parts = words.Split(',');
        var numbers = new double[parts.Length];
        for (var i = 0; i < parts.Length; i++)
        {
            if (!double.TryParse(parts[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]) || !(Math.Abs(numbers[i]) < TooLarge)) return null;
        }

        return numbers;
    }

    private static Diagnostic Wrong(int line, string reason) => TrajectoryRules.LineUnreadable.At(default, line.ToString(CultureInfo.InvariantCulture), reason);
}
