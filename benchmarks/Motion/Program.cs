using System.Globalization;
using Engraver.Benchmarks.Motion;
using Engraver.Benchmarks.Motion.Parts;

CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
switch (args)
{
    case ["parts", var folder]:
        BenchmarkPart.WriteAll(folder);
        return 0;
    case ["path", var engraver, var drawing, var machine, var tolerance, var output]:
        new EngraverProgram(engraver).PathOf(drawing, machine, double.Parse(tolerance, CultureInfo.InvariantCulture)).Write(output);
        return 0;
    case ["limit", var path]:
        var file = PathFile.Read(path);
        Console.WriteLine("| Stroke | Elements | Limit, s | VA, mm/s2 | Unrestricted, s | Stop at every corner, s |");
        Console.WriteLine("|---:|---:|---:|---:|---:|---:|");
        for (var i = 0; i < file.Strokes.Count; i++)
        {
            var limits = StrokeLimits.Of(file.Strokes[i], file.Bounds);
            Console.Write($"| {i} | {file.Strokes[i].Count} | {limits.Limit:0.000000} | {limits.Acceleration:0.0} | ");
            Console.WriteLine($"{limits.Unrestricted:0.000000} | {limits.Stopping:0.000000} |");
        }

        return 0;
    case ["measure", var engraver, var tolerance, var folder, .. var machines] when machines.Length > 0:
        MotionTable.Write(new EngraverProgram(engraver), double.Parse(tolerance, CultureInfo.InvariantCulture), folder, machines);
        return 0;
    case ["load", var engraver, var drawing, var machine, var load, var runs, var atOnce, var link, .. var options]:
        new LoadTable(engraver).Write(drawing, machine, int.Parse(load, CultureInfo.InvariantCulture), int.Parse(runs, CultureInfo.InvariantCulture), int.Parse(atOnce, CultureInfo.InvariantCulture), link, options);
        return 0;
    case ["acceleration", var record, var counts]:
        var a = double.Parse(counts, CultureInfo.InvariantCulture);
        var found = RecordedAcceleration.Of(record, a);
        Console.WriteLine($"{found.Largest / a:0.000} A at {found.X:0}, {found.Y:0} counts; allowed: {found.Allowed / a:0.000} A");
        return found.Largest <= found.Allowed ? 0 : 1;
    default:
        Console.Error.WriteLine(
            """
            usage: Engraver.MotionLimits parts FOLDER
                     write the drawings of the parts into the folder
                   Engraver.MotionLimits path ENGRAVER DRAWING PROFILE TOLERANCE PATH.json
                     write the toolpath of a drawing, with the bounds of the machine and the corner tolerance in mm
                   Engraver.MotionLimits limit PATH.json
                     print the limits of each stroke
                   Engraver.MotionLimits measure ENGRAVER TOLERANCE FOLDER PROFILE...
                     print a table of all drawings of the folder on all machines
                   Engraver.MotionLimits load ENGRAVER DRAWING PROFILE THREADS RUNS AT-ONCE tcp|BAUD [OPTION...]
                     run the drawing in real time on simulated controllers while that many threads compute
                   Engraver.MotionLimits acceleration RECORD.csv COUNTS
                     print the largest acceleration of a record of the simulated controller beside that of its machine, counts/s2
            """);
        return 2;
}
