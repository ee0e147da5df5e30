using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>The actual machine positions of a run, thinned to a size that can be stored: from the simulator's record, or from polled controller
/// positions.</summary>
/// <param name="Source">"record", "polled" or "plan".</param>
/// <param name="Places">Positions in order of time.</param>
public sealed record RunTrace(string Source, IReadOnlyList<RunTracePlace> Places)
{
    private const double MinSecondsOfSpeed = 0.0099;

    /// <summary>The columns of the first version, which had neither the following error nor the drawing.</summary>
    private const string FirstHeader = "seconds,x,y,tool,deviation";

    /// <summary>The columns of the second version, which had neither the feed override nor the load of the link.</summary>
    private const string SecondHeader = FirstHeader + ",following";

    private const string Header = SecondHeader + ",feed,link";

    /// <summary>The first column that may be empty.</summary>
    private const int FollowingColumn = 5;

    private const int FeedColumn = 6;

    private const int LinkColumn = 7;

    private const int Version = 3;

    private const string VersionMark = "; version ";

    private const string DrawingMark = "; drawing ";

    /// <summary>Fingerprint of the drawing that was cut (<see cref="DrawnFingerprint"/>); empty in a trace of the first version.</summary>
    public string Drawing { get; init; } = "";

    /// <summary>True when the following error of at least one place is known.</summary>
    public bool HasFollowing => Places.Any(place => place.FollowingMm is not null);

    /// <summary>True when it can be a run of this drawing; also true for a trace without a fingerprint.</summary>
    public bool CanBeOf(string fingerprint) => Drawing.Length == 0 || Drawing == fingerprint;

    /// <summary>Writes the trace as CSV, lengths in millimetres of the drawing; the first line names the source.</summary>
    public void Write(TextWriter output)
    {
        ArgumentNullException.ThrowIfNull(output);
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"# {Source}{VersionMark}{Version}{DrawingMark}{Drawing}"));
        output.WriteLine(Header);
        foreach (var place in Places)
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{place.Seconds:0.######},{place.Place.X:0.######},{place.Place.Y:0.######},{(place.ToolOn ? 1 : 0)},{place.DeviationMm:0.######},{place.FollowingMm:0.######},{place.Conditions.FeedRatio:0.###},{place.Conditions.LinkLoad:0.###}"));
    }

    /// <summary>Reads what <see cref="Write"/> wrote, in this version or an earlier one.</summary>
    /// <exception cref="FormatException">The text is not a trace; the message names the line.</exception>
    public static RunTrace Read(TextReader input)
    {
        ArgumentNullException.ThrowIfNull(input);
        if (input.ReadLine() is not { } first || !first.StartsWith("# ", StringComparison.Ordinal)) throw new FormatException(Wording.Get("RunTrace.NotTrace", 1));
        var (source, version, drawing) = TitleOf(first[2..]);
        if (version is null or < 1) throw new FormatException(Wording.Get("RunTrace.NotTrace", 1));
        if (version > Version) throw new FormatException(Wording.Get("RunTrace.NewerVersion", version, Version));
        var header = version switch { 1 => FirstHeader, 2 => SecondHeader, _ => Header };
        if (input.ReadLine() != header) throw new FormatException(Wording.Get("RunTrace.NotTrace", version == 1 ? 1 : 2));
        var places = new List<RunTracePlace>();
        for (var line = 3; input.ReadLine() is { } text; line++) places.Add(PlaceOf(text, header.Count(character => character == ',') + 1) ?? throw new FormatException(Wording.Get("RunTrace.NotTrace", line)));
        return new RunTrace(source, places) { Drawing = drawing };
    }

    /// <summary>The source, the version and the drawing of the first line; in the first version only the source.</summary>
    private static (string Source, int? Version, string Drawing) TitleOf(string title)
    {
        var at = title.IndexOf(VersionMark, StringComparison.Ordinal);
        if (at < 0) return (title, 1, "");
        var rest = title[(at + VersionMark.Length)..].Split(DrawingMark);
        return (title[..at], int.TryParse(rest[0].Split(';')[0], NumberStyles.None, CultureInfo.InvariantCulture, out var version) ? version : null, rest is [_, var drawing] ? drawing : "");
    }

    /// <summary>Speed on the way to a place, mm/s, over the last hundredth of a second: one count in a thousandth of a second does not give a usable speed. 0
    /// for the first place, and when no time has passed.</summary>
    public double SpeedTo(int place)
    {
        var (way, first) = (0.0, place);
        while (first > 0 && Places[place].Seconds - Places[first].Seconds < MinSecondsOfSpeed)
        {
            way += Places[first].Place.DistanceTo(Places[first - 1].Place);
            first--;
        }

        return Places[place].Seconds > Places[first].Seconds ? way / (Places[place].Seconds - Places[first].Seconds) : 0.0;
    }

    private static RunTracePlace? PlaceOf(string line, int columns)
    {
        var cells = line.Split(',');
        var numbers = new double?[LinkColumn + 1];
        if (cells.Length != columns) return null;
        for (var i = 0; i < cells.Length; i++)
        {
            if (i >= FollowingColumn && cells[i].Length == 0) continue;
            if (!double.TryParse(cells[i], NumberStyles.Float, CultureInfo.InvariantCulture, out var number) || !double.IsFinite(number)) return null;
            numbers[i] = number;
        }

        if (numbers is not [{ } seconds, { } x, { } y, { } tool, { } deviation, ..]) return null;
        return new RunTracePlace(seconds, new Point2D(x, y), tool == 1.0, deviation, numbers[FollowingColumn]) { Conditions = new TraceConditions(numbers[FeedColumn], numbers[LinkColumn]) };
    }
}
