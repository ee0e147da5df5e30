System.Console.WriteLine("engraver");
