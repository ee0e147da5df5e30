using Engraver.Samples;
using Engraver.Samples.Drawings;

if (BenchmarkRequest.From(args) is { } benchmark)
{
    benchmark.Write();
    return 0;
}

if (args is [var folder] && !folder.StartsWith('-'))
{
    Directory.CreateDirectory(folder);
    foreach (var sample in Sample.All)
    {
        sample.WriteTo(folder);
    }

    File.WriteAllBytes(Path.Combine(folder, OutlineFontFile.FileName), OutlineFontFile.Write());

    return 0;
}

Console.Error.WriteLine(
    """
    usage: Engraver.Samples FOLDER
             write every sample drawing, and the font of the label plate, into the folder
           Engraver.Samples --lines N FILE [--digits D] [--shuffle]
             write a benchmark drawing of N lines; D is 1 to 15 decimals (6 unless told), or 17 for exact text
    """);
return 2;
