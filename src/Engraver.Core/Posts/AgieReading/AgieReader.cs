using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts.AgieReading;

/// <summary>Reads programs for the AGIECUT DEM15 back and runs them as the machine does, based only on its documentation (sace-xps-agie.md 4.1); shares no code
/// with the post.</summary>
/// <remarks>Every field must have its width and a valid value, blocks are numbered from 001, and only the mark of the next program follows the end block of a
/// program. A violation is one finding, and the rest is not run, because the machine position would be unknown.</remarks>
public sealed class AgieReader : IProgramReader
{
    private const int FieldsOfBlock = 8;

    public bool ReportsHeights => false;

    public Task<IReadOnlyList<Diagnostic>> ReplayAsync(TextReader text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(request);
        var machine = new DemMachine(request.Entry ?? request.Machine.Scale.ToMillimetres(request.Start.X, request.Start.Y), request.Judges);
        return Task.FromResult<IReadOnlyList<Diagnostic>>(Run(new ProgramRows(text), machine, cancellation) is { } fault ? [fault] : []);
    }

    private static Diagnostic? Run(ProgramRows lines, DemMachine machine, CancellationToken cancellation)
    {
        var (expected, isInside, isMarked) = (1, false, false);
        while (lines.Next() is { } row)
        {
            cancellation.ThrowIfCancellationRequested();
            var line = lines.Number;
            if (!isInside && !isMarked && row.Length == 0) continue;
            if (row == "%" && !isInside && !isMarked)
            {
                (isMarked, expected) = (true, 1);
                continue;
            }

            var fields = row.Split('\t');
            if (fields[0] == "%" && !isInside && !isMarked) (isMarked, expected) = (true, 1);
            else if (fields[0].Length > 0 || !(isInside || isMarked)) return Fault(line, Wording.Get(isInside || isMarked ? "AgieReader.FirstFieldNotEmpty" : "AgieReader.NoMark", Shown(row)));
            if (Block(fields, expected, out var reason) is not { } block) return Fault(line, reason);
            if (!machine.Execute(block)) return Fault(line, Wording.Get("AgieReader.ArcInPositioning"));
            (isMarked, isInside, expected) = (isMarked && !block.IsLast, !block.IsLast, expected + 1);
        }

        if (isInside || isMarked) return Fault(lines.Number, Wording.Get("AgieReader.NoEnd"));
        return machine.HasMoved ? null : VerificationRules.ProgramEmpty.At(default);
    }

    private static DemBlock? Block(string[] fields, int number, out string reason)
    {
        reason = "";
        if (fields.Length is not (FieldsOfBlock or FieldsOfBlock + 1)) reason = Wording.Get("AgieReader.FieldCount", fields.Length - 1, FieldsOfBlock - 1);
        else if (Digits(fields[1], 3) != number) reason = Wording.Get("AgieReader.BlockNumber", Shown(fields[1]), number.ToString("000", CultureInfo.InvariantCulture));
        else if (Digits(fields[2], 2) is not (>= 1 and <= 3)) reason = Wording.Get("AgieReader.BadInterpolation", Shown(fields[2]));
        else if (Digits(fields[3], 3) is not < 360) reason = Wording.Get("AgieReader.BadAngle", Shown(fields[3]));
        else if (Digits(fields[4], 3) is not < 360) reason = Wording.Get("AgieReader.BadAngle", Shown(fields[4]));
        else if (Signed(fields[5]) is null) reason = Wording.Get("AgieReader.BadLength", Shown(fields[5]));
        else if (Signed(fields[6]) is null) reason = Wording.Get("AgieReader.BadLength", Shown(fields[6]));
        else if (Digits(fields[7], 2) is not (1 or 2)) reason = Wording.Get("AgieReader.BadMode", Shown(fields[7]));
        else if (fields.Length > FieldsOfBlock && fields[8] != "02") reason = Wording.Get("AgieReader.BadEnd", Shown(fields[8]));
        if (reason.Length > 0) return null;
        var block = new DemBlock(Digits(fields[2], 2)!.Value, Digits(fields[3], 3)!.Value, Digits(fields[4], 3)!.Value, Signed(fields[5])!.Value, Signed(fields[6])!.Value, fields[7] == "02", fields.Length > FieldsOfBlock);
        if (block.Interpolation == 1 && (block.Start != 0 || block.Work != 0)) reason = Wording.Get("AgieReader.LineWithAngles");
        else if (block.Interpolation != 1 && (block.Work == 0 || block.X != block.Y || block.X <= 0)) reason = Wording.Get("AgieReader.ArcWithoutRadius");
        return reason.Length > 0 ? null : block;
    }

    private static int? Digits(string field, int width) => field.Length == width && field.All(char.IsAsciiDigit) ? int.Parse(field, CultureInfo.InvariantCulture) : null;

    private static int? Signed(string field)
    {
        if (field.Length != 7 || field[0] is not ('+' or '-') || Digits(field[1..], 6) is not { } value || (field[0] == '-' && value == 0)) return null;
        return field[0] == '-' ? -value : value;
    }

    private static string Shown(string field) => field.Length <= 40 ? field : field[..40];

    private static Diagnostic Fault(int line, string reason) => PostRules.BlockUnreadable.At(new SourceRef(line), line.ToString(CultureInfo.InvariantCulture), reason);

    /// <summary>The fields of a block as numbers.</summary>
    private readonly record struct DemBlock(int Interpolation, int Start, int Work, int X, int Y, bool Sparks, bool IsLast);

    /// <summary>The model of the machine: a position, and a wire that erodes or not. The reported time only gives the order.</summary>
    private sealed class DemMachine(Point2D start, IReadOnlyList<ITraceJudge> judges)
    {
        private double _x = start.X;
        private double _y = start.Y;
        private double _seconds;

        public bool HasMoved { get; private set; }

        /// <returns>False for an arc without erosion, which the format does not have.</returns>
        public bool Execute(DemBlock block)
        {
            HasMoved = true;
            if (block.Interpolation == 1) RunLine(block);
            else if (block.Sparks) RunArc(block);
            return block.Sparks || block.Interpolation == 1;
        }

        private void RunLine(DemBlock block)
        {
            var from = new Point2D(_x, _y);
            (_x, _y) = (_x + (block.X / 1000.0), _y + (block.Y / 1000.0));
            if (block.Sparks) AddSpan(Segment.FromLine(from, new Point2D(_x, _y)));
            else foreach (var judge in judges) judge.Add(new TraceSample(_seconds += 1.0, _x, _y, Cutting: false));
        }

        /// <summary>In quarters of a turn at most, as the judges require arcs. 02 runs clockwise.</summary>
        private void RunArc(DemBlock block)
        {
            var (radius, turn, angle) = (block.X / 1000.0, block.Interpolation == 2 ? -block.Work : block.Work, block.Start * Math.PI / 180.0);
            var (x, y) = (_x - (radius * Math.Cos(angle)), _y - (radius * Math.Sin(angle)));
            var parts = (block.Work + 89) / 90;
            for (var i = 0; i < parts; i++)
                AddSpan(Segment.FromArc(new ArcSegment(new Point2D(x, y), radius, Angle.FromDegrees(block.Start + ((double)turn * i / parts)), Angle.FromDegrees((double)turn / parts))));
            var end = (block.Start + turn) * Math.PI / 180.0;
            (_x, _y) = (x + (radius * Math.Cos(end)), y + (radius * Math.Sin(end)));
        }

        private void AddSpan(in Segment path)
        {
            if (path.Length == 0.0) return;
            if (_seconds == 0.0) Dwell(path.Start);
            foreach (var judge in judges) judge.Add(new TraceSpan(_seconds, _seconds + 1.0, 2, path, Cutting: true));
            _seconds += 1.0;
        }

        private void Dwell(Point2D place)
        {
            foreach (var judge in judges) judge.Add(new TraceSample(_seconds, place.X, place.Y, Cutting: false));
            _seconds += 1.0;
        }
    }
}
